// SPDX-License-Identifier: Apache-2.0
// What a comparison of the hardware's, blended over four texels, is made with.
#include "receiver.glsl"

/// The tangent plane where the tap lies, less what it drops within the four texels: all are compared with one distance.
float blended_tap_distance(LightViewData view, Receiver receiver, vec2 lateral) {
  float reach_texels = sqrt(2.0);  // const: the farthest of the four centres
  float drop = reach_texels * texel_world(view, receiver.p_light.z) * receiver.slope;
  return plane_distance_at(view, receiver, lateral) - drop - receiver.bias_world;
}

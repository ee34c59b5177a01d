// SPDX-License-Identifier: Apache-2.0
// A receiver behind filtered moments, for techniques with the parameters of the group moments.
#include "moments.glsl"
#include "receiver.glsl"

/// Smallest variance that is believed, of normalised distances.
float least_variance(LightViewData view) {
  float from_world = normalized_length(view, min_deviation_world);
  float range = normalized_length(view, view.depth_range.y - view.depth_range.x);
  return max(from_world * from_world, min_variance_of_range * range * range);
}

float variance_visibility(LightViewData view, Receiver receiver, vec2 moments) {
  float z = normalized_distance(view, receiver.p_light.z - receiver.bias_world);
  return without_bleeding(chebyshev(moments, z, least_variance(view)), bleed_reduction);
}

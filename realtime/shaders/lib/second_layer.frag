// SPDX-License-Identifier: Apache-2.0
// Keeps the second surface along each texel's ray: peels off the nearest one and what lies on it.
#include "spaces.glsl"

in float distance_world;

void main() {
  const float kSameLayerTexels = 0.25;  // const: surfaces closer together than this are one
  float first = distance_of_depth(VIEW, texelFetch(first_layer, ivec2(gl_FragCoord.xy), 0).r);
  if (distance_world <= first + kSameLayerTexels * texel_world(VIEW, first)) discard;
  gl_FragDepth = gl_FragCoord.z;
}

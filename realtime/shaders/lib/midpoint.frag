// SPDX-License-Identifier: Apache-2.0
// The middle between the two nearest layers (Woo 1992); a lone layer lies a texel deeper.
#include "spaces.glsl"

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float first_depth = texelFetch(first_layer, texel, 0).r;
  float second_depth = texelFetch(second_layer, texel, 0).r;
  float first = distance_of_depth(view_light, first_depth);
  float second = second_depth > 0.0 ? distance_of_depth(view_light, second_depth)
                                    : first + 2.0 * texel_world(view_light, first);  // const: their middle is a texel away
  gl_FragDepth = first_depth > 0.0 ? depth_of_distance(view_light, 0.5 * (first + second)) : 0.0;
}

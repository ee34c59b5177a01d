// SPDX-License-Identifier: Apache-2.0
// The farthest that a texel's surface may lie behind its nearest one; the depth test leaves what is nearer.
#include "spaces.glsl"

void main() {
  float first_depth = texelFetch(first_layer, ivec2(gl_FragCoord.xy), 0).r;
  float first = distance_of_depth(view_light, first_depth);
  float limit = first + deepest_texels * texel_world(view_light, first);
  gl_FragDepth = first_depth > 0.0 ? depth_of_distance(view_light, limit) : 0.0;
}

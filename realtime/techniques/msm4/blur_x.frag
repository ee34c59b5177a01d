// SPDX-License-Identifier: Apache-2.0
// First half of the box filter, over the moments of each texel; beyond the map is nothing: far.
#include "box_filter.glsl"
#include "four_moments.glsl"

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float low = 0.5 - 0.5 * filter_width_texels;
  float high = 0.5 + 0.5 * filter_width_texels;
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = int(floor(low)); i <= last_texel(low, high); ++i) {
    int x = texel.x + i;
    bool is_inside = x >= 0 && x < textureSize(surface, 0).x;
    float weight = box_weight(i, low, high);
    sum += weight * encoded(is_inside ? texelFetch(surface, ivec2(x, texel.y), 0).r : 1.0);
    total += weight;
  }
  out_moments_x = sum / total;
}

// SPDX-License-Identifier: Apache-2.0
// First half of the box filter, over the moments of each texel; beyond the map is nothing: far.
#include "box_filter.glsl"
#include "six_moments.glsl"

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float low = 0.5 - 0.5 * filter_width_texels;
  float high = 0.5 + 0.5 * filter_width_texels;
  vec3 odd = vec3(0.0);
  vec3 even = vec3(0.0);
  float total = 0.0;
  for (int i = int(floor(low)); i <= last_texel(low, high); ++i) {
    int x = texel.x + i;
    bool is_inside = x >= 0 && x < textureSize(surface, 0).x;
    float weight = box_weight(i, low, high);
    Moments m = encoded(is_inside ? texelFetch(surface, ivec2(x, texel.y), 0).r : 1.0);
    odd += weight * m.odd;
    even += weight * m.even;
    total += weight;
  }
  out_low_x = vec2(odd.x, even.x) / total;
  out_middle_x = vec2(odd.y, even.y) / total;
  out_high_x = vec2(odd.z, even.z) / total;
}

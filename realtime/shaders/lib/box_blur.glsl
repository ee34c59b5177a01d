// SPDX-License-Identifier: Apache-2.0
// One axis of a separable box of real-valued width over the texels of a map.
#include "box_filter.glsl"

/// Mean of `map` over [t - w/2, t + w/2] along `axis`, t the middle of `texel`; `outside` is what lies beyond the map.
vec4 box_mean(sampler2D map, ivec2 texel, ivec2 axis, float width_texels, vec4 outside) {
  ivec2 size = textureSize(map, 0);
  float low = 0.5 - 0.5 * width_texels;
  float high = 0.5 + 0.5 * width_texels;
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = int(floor(low)); i <= last_texel(low, high); ++i) {
    ivec2 tap = texel + i * axis;
    bool is_inside = all(greaterThanEqual(tap, ivec2(0))) && all(lessThan(tap, size));
    float weight = box_weight(i, low, high);
    sum += weight * (is_inside ? texelFetch(map, tap, 0) : outside);
    total += weight;
  }
  return sum / total;
}

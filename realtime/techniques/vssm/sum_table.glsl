// SPDX-License-Identifier: Apache-2.0
// The mean over any box of a map, from its table of sums (Crow 1984).
#include "sum_scale.glsl"

/// Sum over the texels before `corner` along both axes, modulo 2^32.
uvec2 sum_before(ivec2 corner) {
  if (corner.x <= 0 || corner.y <= 0) return uvec2(0u);
  return texelFetch(sums, min(corner, textureSize(sums, 0)) - 1, 0).rg;
}

/// Sum over the texels from `low` to before `high`.
vec2 sum_between(ivec2 low, ivec2 high) {
  return vec2(sum_before(high) - sum_before(ivec2(low.x, high.y)) - sum_before(ivec2(high.x, low.y)) +
              sum_before(low));
}

/// The same with `high` between texels.
vec2 sum_to(ivec2 low, vec2 high) {
  ivec2 whole = ivec2(floor(high));
  vec2 share = high - vec2(whole);
  vec2 upper = mix(sum_between(low, whole + ivec2(0, 1)), sum_between(low, whole + 1), share.x);
  vec2 lower = mix(sum_between(low, whole), sum_between(low, whole + ivec2(1, 0)), share.x);
  return mix(lower, upper, share.y);
}

/// Mean moments over a box between texels; beyond the map is nothing: far.
vec2 mean_over(vec2 low_texels, vec2 high_texels) {
  vec2 size = vec2(textureSize(sums, 0));
  vec2 low = clamp(low_texels, vec2(0.0), size);
  vec2 high = clamp(high_texels, low, size);
  ivec2 from = ivec2(floor(low));
  vec2 sum = sum_to(from, high) - sum_to(from, vec2(low.x, high.y)) - sum_to(from, vec2(high.x, low.y)) +
             sum_to(from, low);
  vec2 all = high_texels - low_texels;
  vec2 inside = high - low;
  float area = all.x * all.y;
  return (sum / kSumScale + vec2(area - inside.x * inside.y)) / area;
}

// SPDX-License-Identifier: Apache-2.0
// What an exponential shadow map holds, and how such values are averaged.
#include "box_filter.glsl"
#include "moments.glsl"

/// The stored value of a normalised distance. exp(c (z - 1)) instead of exp(c z): empty texels hold 1 and c = 80 stays
/// inside a float's range at both ends.
float stored_value(float z) { return FORM == FORM_EXPONENTIAL ? exp(exponent * (z - 1.0)) : z; }

/// A running weighted mean of stored values. In log space it is kept as exp(c (z - highest)), so that no c overflows.
struct FilterSum {
  float sum;
  float total;
  float highest;
};

FilterSum empty_sum() { return FilterSum(0.0, 0.0, 0.0); }

void add_to(inout FilterSum filtered, float value, float weight) {
  if (weight <= 0.0) return;  // must not become the highest
  filtered.total += weight;
  if (FORM != FORM_LOG_SPACE) {
    filtered.sum += weight * value;
    return;
  }
  float highest = max(filtered.highest, value);
  float rescaled = filtered.sum * exp(exponent * (filtered.highest - highest));
  filtered.sum = rescaled + weight * exp(exponent * (value - highest));
  filtered.highest = highest;
}

float mean_of(FilterSum filtered) {
  float mean = filtered.sum / filtered.total;
  return FORM == FORM_LOG_SPACE ? filtered.highest + log(mean) / exponent : mean;
}

/// The stored value of a texel; beyond the map is nothing: far.
float value_at(sampler2D map, ivec2 texel) {
  ivec2 size = textureSize(map, 0);
  bool is_inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
  return is_inside ? texelFetch(map, texel, 0).r : 1.0;
}

/// One axis of the box filter around the middle of `texel`.
float box_mean(sampler2D map, ivec2 texel, ivec2 axis, float width_texels) {
  float low = 0.5 - 0.5 * width_texels;
  float high = 0.5 + 0.5 * width_texels;
  FilterSum filtered = empty_sum();
  for (int i = int(floor(low)); i <= last_texel(low, high); ++i) {
    add_to(filtered, value_at(map, texel + i * axis), box_weight(i, low, high));
  }
  return mean_of(filtered);
}

/// The bilinear read; in log space a sampler's would not be a mean.
float bilinear_mean(sampler2D map, vec2 p_texels) {
  vec2 low = floor(p_texels - 0.5);
  vec2 share = p_texels - 0.5 - low;
  FilterSum filtered = empty_sum();
  for (int i = 0; i < 4; ++i) {  // const: the corners of a square
    vec2 corner = vec2(i & 1, i >> 1);
    vec2 weights = mix(1.0 - share, share, corner);
    add_to(filtered, value_at(map, ivec2(low + corner)), weights.x * weights.y);
  }
  return mean_of(filtered);
}

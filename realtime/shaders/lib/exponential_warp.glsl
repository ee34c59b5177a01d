// SPDX-License-Identifier: Apache-2.0
// The two warps of exponential variance shadow maps, for techniques with the parameters of the group exponents.
#include "moments.glsl"

/// (exp(c+ t), -exp(-c- t)) of t = 2 z - 1: the first magnifies what is far, the second what is near.
vec2 warped(float z) {
  float t = 2.0 * z - 1.0;
  return vec2(exp(positive_exponent * t), -exp(-negative_exponent * t));
}

/// Derivatives by z.
vec2 warped_slope(vec2 warped_z) { return 2.0 * vec2(positive_exponent, -negative_exponent) * warped_z; }

/// (w+, w-, w+^2, w-^2), the squares with the variance that z has inside a texel.
vec4 warped_moments(float z, float variance) {
  vec2 w = warped(z);
  vec2 slope = warped_slope(w);
  return vec4(w, w * w + slope * slope * variance);
}

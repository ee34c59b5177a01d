// SPDX-License-Identifier: Apache-2.0
// Exponential variance shadow maps (Lauritzen and McCool 2008): Chebyshev's bound in two warped distances, the lower
// one counts. For techniques with the parameters of the groups exponents, moments, filtered_plane and box_prefilter.
#include "exponential_warp.glsl"
#include "filtered_plane.glsl"
#include "variance_bound.glsl"

/// What the filter holds of the receiver's own plane. The positive warp is convex: no less than the receiver's own
/// value, or than that of the plane's nearer half with plane_bias. The negative one is concave: its mean over a plane lies
/// before the receiver. No map holds less than at 0.
vec2 warped_plane(LightViewData view, Receiver receiver, vec2 w) {
  float z = receiver.p_light.z;
  vec2 spreads = normalized_length(view, 1.0, z) * plane_spreads_world(view, receiver, filter_width_texels);
  float spread = normalized_length(view, plane_spread_world(view, receiver, filter_width_texels), z);
  float positive = half_plane_exponential(2.0 * positive_exponent * spread);
  float negative = half_plane_exponential(-2.0 * negative_exponent * spread);
  negative = max(negative, plane_exponential(2.0 * negative_exponent * spreads));
  return max(w * vec2(positive, negative), warped(0.0));
}

/// The bound for one warp, `axis` 0 or 1; a deviation grows with the warp's slope at the receiver.
float warped_bound(vec4 filtered, vec2 w, vec2 min_deviation, int axis) {
  return chebyshev(vec2(filtered[axis], filtered[axis + 2]), w[axis], min_deviation[axis] * min_deviation[axis]);
}

/// Of a receiver behind filtered warped moments.
float exponential_visibility(LightViewData view, Receiver receiver, vec4 filtered) {
  float z = normalized_distance(view, receiver.p_light.z - receiver.bias_world);
  vec2 w = warped(z);
  vec2 min_deviation = warped_slope(w) * sqrt(least_variance(view, receiver.p_light.z));
  vec2 reference = warped_plane(view, receiver, w);
  float positive = warped_bound(filtered, reference, min_deviation, 0);
  float negative = NEGATIVE_WARP != 0 ? warped_bound(filtered, reference, min_deviation, 1) : 1.0;
  return without_bleeding(min(positive, negative), bleed_reduction);
}

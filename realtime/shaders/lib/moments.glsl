// SPDX-License-Identifier: Apache-2.0
// Moments of the distances a filter covers, and what they say about a receiver behind them.
// Distances here are normalised: 0 at the view's near plane, 1 behind the far one, where nothing is. For techniques with
// the parameter depth_form.
#include "spaces.glsl"

/// World length of normalised 1. Past the far plane, which is at the farthest receiver: a surface that goes on beyond
/// it must not be flattened inside a filter, or it shadows itself.
float range_world(LightViewData view) {
  return 1.25 * (view.depth_range.y - view.depth_range.x);  // const: room for a filter on a slope
}

/// Casters before the near plane lie on it. Stored depth is that of conventional buffers, 0 near and 1 far.
float normalized_distance(LightViewData view, float distance_world) {
  if (DEPTH_FORM == DEPTH_FORM_STORED) return 1.0 - depth_of_distance(view, distance_world);
  return clamp((distance_world - view.depth_range.x) / range_world(view), 0.0, 1.0);
}

/// The distance that normalized_distance turns back, within the range.
float distance_of_normalized(LightViewData view, float z) {
  if (DEPTH_FORM == DEPTH_FORM_STORED) return distance_of_depth(view, 1.0 - z);
  return view.depth_range.x + z * range_world(view);
}

/// A world length as a difference of normalised distances about `distance_world`. Stored depth of a perspective view
/// is f (z - n) / (z (f - n)), which rises by n f / (z^2 (f - n)).
float normalized_length(LightViewData view, float length_world, float distance_world) {
  if (DEPTH_FORM != DEPTH_FORM_STORED) return length_world / range_world(view);
  float near_world = view.depth_range.x;
  float far_world = view.depth_range.y;
  float z = max(distance_world, near_world);
  float per_range = is_orthographic(view) ? 1.0 : near_world * far_world / (z * z);
  return length_world * per_range / (far_world - near_world);
}

/// The map's range of distances, normalised.
float normalized_range(LightViewData view) {
  return DEPTH_FORM == DEPTH_FORM_STORED ? 1.0 : (view.depth_range.y - view.depth_range.x) / range_world(view);
}

/// Variance of the distance inside a texel over which it changes by `slope`: slope^2 / 12 per axis for a box, / 4 for
/// a Gaussian of half a texel (Donnelly and Lauritzen 2006). `texel_normalized` limits the slope to that of a surface seen
/// at 84 degrees: an edge-on triangle's has no bound.
float texel_variance_of(vec2 slope, float variance_per_slope2, float texel_normalized) {
  const float kMaxSlope = 10.0;  // const: tangent of the incidence angle
  vec2 limited = min(abs(slope), kMaxSlope * texel_normalized);
  return variance_per_slope2 * dot(limited, limited);
}

/// Moments of distances that are all farther by `shift`.
vec2 shifted_moments(vec2 m, float shift) { return vec2(m.x + shift, m.y + shift * (2.0 * m.x + shift)); }

/// Share of the filter not nearer than `z`, at most: Chebyshev's one-sided inequality. Exact when all that is nearer
/// lies at one distance and the rest at z. `moments` = (mean, mean square).
float chebyshev(vec2 moments, float z, float min_variance) {
  float variance = max(moments.y - moments.x * moments.x, min_variance);
  float beyond = z - moments.x;
  return beyond <= 0.0 ? 1.0 : variance / (variance + beyond * beyond);
}

/// What the bound leaks where the truth is 0 lies below some share a: [a, 1] becomes [0, 1] (Lauritzen 2008).
float without_bleeding(float bound, float bleed_reduction) {
  return clamp((bound - bleed_reduction) / (1.0 - bleed_reduction), 0.0, 1.0);
}

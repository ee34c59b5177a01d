// SPDX-License-Identifier: Apache-2.0
// The receiver's own plane inside a filter, for techniques with the parameter plane_bias of the group
// filtered_plane. Where a surface ends at a concave edge the filter holds its nearer half and, beyond the edge, distances
// about the receiver's: less than the receiver, yet no blocker. A blocker is nearer than min(plane, receiver).
#include "receiver.glsl"

/// Change of the plane's distance over a texel along each axis: orthographic -n.xy / n.z, perspective -z^2 n.xy / (n.p)
/// times the texel's size. The slope is limited as for single texels.
vec2 plane_change_per_texel(LightViewData view, Receiver receiver) {
  vec2 texel = (view.lateral_bounds.zw - view.lateral_bounds.xy) / view.depth_range.w;
  float z = receiver.p_light.z;
  bool ortho = is_orthographic(view);
  float along = ortho ? receiver.n_light.z : receiver.plane_distance / (z * z);
  vec2 steepest = kMaxPlaneSlope * texel * (ortho ? 1.0 : z);
  return min(abs(receiver.n_light.xy) * texel / max(abs(along), 1e-20), steepest);  // const: edge-on
}

/// Half widths, in the world, of the uniform spreads along both axes whose variance is at least the plane's inside a box
/// of `width_texels`: (w^2 - 1) / 12 texels squared for texel centres and up to 1/4 for a bilinear read between two.
vec2 plane_spreads_world(LightViewData view, Receiver receiver, float width_texels) {
  float width = max(1.0, width_texels);
  return 0.5 * sqrt(width * width + 2.0) * plane_change_per_texel(view, receiver);
}

/// Along the steepest direction; 0 with the parameter off.
float plane_spread_world(LightViewData view, Receiver receiver, float width_texels) {
  return PLANE_BIAS != 0 ? length(plane_spreads_world(view, receiver, width_texels)) : 0.0;
}

/// Mean distance by which min(plane, receiver) lies before the receiver: half of a uniform spread s, s / 2 on average.
float plane_bias_world(LightViewData view, Receiver receiver, float width_texels) {
  return 0.25 * plane_spread_world(view, receiver, width_texels);  // const: a half of a half
}

/// Mean of exp(min(plane, receiver) - receiver) for a spread s times the exponent: 1/2 + (1 - exp(-x)) / (2 x); below 0
/// for the exponential that falls with distance.
float half_plane_exponential(float x) {
  if (abs(x) < 1e-3) return 1.0 - 0.25 * x;  // const: series where the quotient cancels
  return 0.5 + 0.5 * (1.0 - exp(-x)) / x;
}

/// Mean of exp(plane - receiver) for spreads along two axes times the exponent: sinh(x) / x each.
float plane_exponential(vec2 x) {
  vec2 safe = max(abs(x), 1e-3);  // const: the quotient is 1 to rounding
  vec2 each = 0.5 * (exp(safe) - exp(-safe)) / safe;
  return max(1.0, each.x * each.y);
}

// SPDX-License-Identifier: Apache-2.0
// A mean blocker distance as a number that blurs and interpolates: the width of the penumbra, 0 at the contact, 1 for
// the widest that the view can hold (physical), or the value of the curve.
#include "penumbra.glsl"

/// Kernel widths are linear in 1/z in a perspective view and in z in an orthographic one.
float widest_penumbra(LightViewData view) {
  vec2 range_world = view.depth_range.xy;
  return is_orthographic(view) ? range_world.y - range_world.x : 1.0 / range_world.x - 1.0 / range_world.y;
}

float penumbra_of(LightViewData view, float z_receiver, float z_blocker) {
#ifdef PENUMBRA_CURVE
  if (kHasCurve) return curve_value(view, z_receiver, z_blocker);
#endif
  float width = is_orthographic(view) ? z_receiver - z_blocker : 1.0 / z_blocker - 1.0 / z_receiver;
  return clamp(width / widest_penumbra(view), 0.0, 1.0);
}

/// The distance of which `penumbra_of` is `penumbra`.
float blocker_distance_of(LightViewData view, float z_receiver, float penumbra) {
#ifdef PENUMBRA_CURVE
  if (kHasCurve) return curve_blocker_distance(view, z_receiver, penumbra);
#endif
  float width = penumbra * widest_penumbra(view);
  return is_orthographic(view) ? z_receiver - width : 1.0 / (1.0 / z_receiver + width);
}

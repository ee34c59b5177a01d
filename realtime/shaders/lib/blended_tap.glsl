// SPDX-License-Identifier: Apache-2.0
// What a comparison of the hardware's, blended over several texels, is made with: one distance for all of them.
#include "receiver.glsl"

/// The least distance at which texels up to `reach_texels` aside along each axis can hold the tangent plane, which a tap meets
/// at `z`. Perspective: z = c / n.(l, 1), so that l changes n.(l, 1); orthographic: z = (c - n.l) / n.z. Within the limited
/// slope.
float nearest_within(LightViewData view, Receiver receiver, float z, float reach_texels) {
  vec2 reach = reach_texels * (view.lateral_bounds.zw - view.lateral_bounds.xy) / view.depth_range.w;
  vec3 n = abs(receiver.n_light);
  float change = dot(n.xy, reach);
  if (is_orthographic(view)) return z - change / max(n.z, length(n.xy) / kMaxPlaneSlope);
  float c = max(-receiver.plane_distance, length(receiver.p_light) / kMaxPlaneSlope);
  return z / (1.0 + change * z / c);
}

/// Of a tap blended over the four texels around it.
float blended_tap_distance(LightViewData view, Receiver receiver, vec2 lateral) {
  float z_plane = plane_distance_at(view, receiver, lateral);
  return nearest_within(view, receiver, z_plane, 1.0) - receiver.bias_world;
}

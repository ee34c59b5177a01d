// SPDX-License-Identifier: Apache-2.0
// The window whose nearest distance stands for the blockers.
#include "kernel_light.glsl"

const float kCellTexels = 4.0;  // const: texels a side of a cell of nearest_4

/// Cells from the middle of the window to its edge. Blockers of any receiver lie within half the light times the width
/// of the deepest penumbra, h (1/z_near - 1/z_far); sun: (z_far - z_near) tan a.
ivec2 window_radius_cells(LightViewData view) {
  if (WINDOW == WINDOW_FIXED) return ivec2(2);  // const: 5 x 5, as published
  vec2 range_world = view.depth_range.xy;
  float width = is_orthographic(view) ? range_world.y - range_world.x : 1.0 / range_world.x - 1.0 / range_world.y;
  vec2 cell = kCellTexels / view.depth_range.w * (view.lateral_bounds.zw - view.lateral_bounds.xy);
  return ivec2(ceil(width * kernel_light().half_extent / cell));
}

/// Nearest (greatest reversed) depth within `radius` cells along `axis`.
float nearest_along(sampler2D map, ivec2 cell, ivec2 axis, int radius) {
  ivec2 last = textureSize(map, 0) - 1;
  float nearest = 0.0;
  int first = max(-radius, -(axis.x * cell.x + axis.y * cell.y));
  int end = min(radius, axis.x * (last.x - cell.x) + axis.y * (last.y - cell.y));
  for (int i = first; i <= end; ++i) nearest = max(nearest, texelFetch(map, cell + i * axis, 0).r);
  return nearest;
}

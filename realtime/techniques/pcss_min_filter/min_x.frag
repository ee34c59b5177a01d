// SPDX-License-Identifier: Apache-2.0
// First half of the minimum over the window.
#include "min_window.glsl"

void main() {
  int radius = window_radius_cells(view_light).x;
  out_min_x = nearest_along(nearest_4, ivec2(gl_FragCoord.xy), ivec2(1, 0), radius);
}

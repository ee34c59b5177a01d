// SPDX-License-Identifier: Apache-2.0
// Second half of the minimum over the window.
#include "min_window.glsl"

void main() {
  int radius = window_radius_cells(view_light).y;
  out_nearest_4 = nearest_along(min_x, ivec2(gl_FragCoord.xy), ivec2(0, 1), radius);
}

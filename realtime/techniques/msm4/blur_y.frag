// SPDX-License-Identifier: Apache-2.0
// Second half of the box filter; beyond the map is nothing: far.
#include "box_blur.glsl"
#include "four_moments.glsl"

void main() {
  out_moments = box_mean(moments_x, ivec2(gl_FragCoord.xy), ivec2(0, 1), filter_width_texels, encoded(1.0));
}

// SPDX-License-Identifier: Apache-2.0
// Second half of the box filter over the resource `moments`; beyond the map is nothing: far.
#include "box_blur.glsl"

void main() {
  out_moments = box_mean(moments_x, ivec2(gl_FragCoord.xy), ivec2(0, 1), filter_width_texels, vec4(1.0)).rg;
}

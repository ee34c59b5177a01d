// SPDX-License-Identifier: Apache-2.0
// First half of the box filter over the resource `moments`; beyond the map is nothing: far.
#include "box_blur.glsl"

void main() {
  out_moments_x = box_mean(moments, ivec2(gl_FragCoord.xy), ivec2(1, 0), filter_width_texels, vec4(1.0)).rg;
}

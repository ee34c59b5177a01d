// SPDX-License-Identifier: Apache-2.0
// Second half of the box filter; beyond the map is nothing: far.
#include "box_blur.glsl"
#include "exponential_warp.glsl"

void main() {
  vec4 far = warped_moments(1.0, 0.0);
  out_moments = box_mean(moments_x, ivec2(gl_FragCoord.xy), ivec2(0, 1), filter_width_texels, far);
}

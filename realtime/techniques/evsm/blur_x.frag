// SPDX-License-Identifier: Apache-2.0
// First half of the box filter; beyond the map is nothing: far.
#include "box_blur.glsl"
#include "exponential_warp.glsl"

void main() {
  vec4 far = warped_moments(1.0, 0.0);
  out_moments_x = box_mean(moments, ivec2(gl_FragCoord.xy), ivec2(1, 0), filter_width_texels, far);
}

// SPDX-License-Identifier: Apache-2.0
// Second half of the box filter; beyond the map is nothing: far.
#include "box_blur.glsl"
#include "six_moments.glsl"

vec2 mean_of(sampler2D half_blurred, float odd, float even) {
  return box_mean(half_blurred, ivec2(gl_FragCoord.xy), ivec2(0, 1), filter_width_texels, vec4(odd, even, 0.0, 0.0)).xy;
}

void main() {
  Moments far = encoded(1.0);
  out_moments_low = mean_of(low_x, far.odd.x, far.even.x);
  out_moments_middle = mean_of(middle_x, far.odd.y, far.even.y);
  out_moments_high = mean_of(high_x, far.odd.z, far.even.z);
}

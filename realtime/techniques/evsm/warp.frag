// SPDX-License-Identifier: Apache-2.0
// Four moments of every texel.
#include "exponential_warp.glsl"

void main() {
  vec2 z_and_variance = texelFetch(surface, ivec2(gl_FragCoord.xy), 0).rg;
  out_moments = warped_moments(z_and_variance.x, z_and_variance.y);
}

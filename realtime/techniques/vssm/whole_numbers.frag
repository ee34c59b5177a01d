// SPDX-License-Identifier: Apache-2.0
// Mean and mean square of a texel's distances as whole numbers, which sums lose nothing of.
#include "sum_scale.glsl"

void main() {
  vec2 z_and_variance = texelFetch(surface, ivec2(gl_FragCoord.xy), 0).rg;
  float z = z_and_variance.x;
  out_sums = uvec2(kSumScale * vec2(z, min(1.0, z * z + z_and_variance.y)) + 0.5);
}

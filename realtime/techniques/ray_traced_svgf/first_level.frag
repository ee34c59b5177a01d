// SPDX-License-Identifier: Apache-2.0
// The wavelet's first level, between neighbours. The next frame goes on from what it leaves.
#include "wavelet.glsl"

void main() {
  out_odd = filtered(even, 1);
  out_kept = vec4(out_odd.r, texelFetch(accumulated, ivec2(gl_FragCoord.xy), 0).gba);
}

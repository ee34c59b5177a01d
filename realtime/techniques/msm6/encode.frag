// SPDX-License-Identifier: Apache-2.0
// The moments of every texel, where nothing blurs them.
#include "six_moments.glsl"

void main() {
  Moments m = encoded(texelFetch(surface, ivec2(gl_FragCoord.xy), 0).r);
  out_moments_low = vec2(m.odd.x, m.even.x);
  out_moments_middle = vec2(m.odd.y, m.even.y);
  out_moments_high = vec2(m.odd.z, m.even.z);
}

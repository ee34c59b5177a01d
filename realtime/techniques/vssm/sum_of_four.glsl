// SPDX-License-Identifier: Apache-2.0
// Recursive doubling, four at a time (Hensley et al. 2005). Sums go around at 2^32; differences of them do not mind.

uvec2 sum_of_four(usampler2D map, ivec2 stride) {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  uvec2 sum = uvec2(0u);
  for (int i = 0; i < 4; ++i) {  // const: two bits
    ivec2 tap = texel - i * stride;
    if (tap.x >= 0 && tap.y >= 0) sum += texelFetch(map, tap, 0).rg;
  }
  return sum;
}

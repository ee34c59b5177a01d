// SPDX-License-Identifier: Apache-2.0
// One level of a mask's mip chain: a texel holds the most of the four below it. Averages of bilinear reads, clamped to
// on above 0, as published, say the same.

void main() {
  ivec2 first = 2 * ivec2(gl_FragCoord.xy);
  float highest = 0.0;
  for (int i = 0; i < 4; ++i) {  // const: the texels below
    highest = max(highest, texelFetch(mask, first + ivec2(i & 1, i >> 1), 0).r);
  }
  out_mask = highest;
}

// SPDX-License-Identifier: Apache-2.0
// Reading a level of a mask whose texels hold the most of all those below them.

/// The most that the four texels of a level around a place hold, all of what a bilinear read would blend: whatever lies
/// within half such a texel of the place, so within 2^(level - 1) texels of level 0.
float highest_around(sampler2D mask, int level, vec2 p_texels) {
  ivec2 last = textureSize(mask, level) - 1;
  ivec2 low = ivec2(floor(ldexp(p_texels, ivec2(-level)) - 0.5));
  float highest = 0.0;
  for (int i = 0; i < 4; ++i) {  // const: the corners of a square
    ivec2 texel = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), last);
    highest = max(highest, texelFetch(mask, texel, level).r);
  }
  return highest;
}

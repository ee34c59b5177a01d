// A mask over blocks of a map's texels.

/// The most that the four blocks around a place hold: all of what a bilinear read would blend. Whatever lies within half
/// a block of the place is among them.
float highest_around(sampler2D mask, vec2 p_blocks) {
  ivec2 last = textureSize(mask, 0) - 1;
  ivec2 low = ivec2(floor(p_blocks - 0.5));
  float highest = 0.0;
  for (int i = 0; i < 4; ++i) {  // const: the corners of a square
    ivec2 block = clamp(low + ivec2(i & 1, i >> 1), ivec2(0), last);
    highest = max(highest, texelFetch(mask, block, 0).r);
  }
  return highest;
}

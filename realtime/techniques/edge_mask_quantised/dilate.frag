// The highest band in every block of texels.

void main() {
  float widest = max(width_1_texels, max(width_2_texels, width_3_texels));
  int levels = max(0, int(ceil(log2(max(1.0, widest)))) + extra_levels);
  ivec2 block_texels = min(ivec2(1 << levels), textureSize(bands, 0));
  ivec2 first = ivec2(gl_FragCoord.xy) * block_texels;
  float highest = 0.0;
  for (int y = 0; y < block_texels.y; ++y) {
    for (int x = 0; x < block_texels.x; ++x) highest = max(highest, texelFetch(bands, first + ivec2(x, y), 0).r);
  }
  out_mask = highest;
}

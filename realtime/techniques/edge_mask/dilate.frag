// On for every block of texels that holds an edge.

void main() {
  int levels = max(0, int(ceil(log2(max(1.0, filter_width_texels)))) + extra_levels);
  ivec2 block_texels = min(ivec2(1 << levels), textureSize(edges, 0));
  ivec2 first = ivec2(gl_FragCoord.xy) * block_texels;
  float highest = 0.0;
  for (int y = 0; y < block_texels.y; ++y) {
    for (int x = 0; x < block_texels.x; ++x) highest = max(highest, texelFetch(edges, first + ivec2(x, y), 0).r);
  }
  out_mask = highest;
}

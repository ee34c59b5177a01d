// Least and largest reversed depth of each block of the map.
#include "blocks.glsl"

void main() {
  ivec2 first = kBlockTexels * ivec2(gl_FragCoord.xy);
  vec2 least_and_largest = vec2(1.0, 0.0);
  for (int i = 0; i < kBlockTexels * kBlockTexels; ++i) {
    float depth_reversed = texelFetch(shadow_map, first + ivec2(i % kBlockTexels, i / kBlockTexels), 0).r;
    least_and_largest = vec2(min(least_and_largest.x, depth_reversed), max(least_and_largest.y, depth_reversed));
  }
  out_blocks = least_and_largest;
}

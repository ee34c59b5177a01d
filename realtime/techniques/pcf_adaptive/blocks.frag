// SPDX-License-Identifier: Apache-2.0
// One block of the map. Any slope would do; that of the block's rims is exact where it holds a single plane.
#include "blocks.glsl"

float depth_at(ivec2 texel) { return texelFetch(shadow_map, texel, 0).r; }

void main() {
  const int last = kBlockTexels - 1;
  ivec2 first = kBlockTexels * ivec2(gl_FragCoord.xy);
  float corner = depth_at(first);
  vec2 slope = (vec2(depth_at(first + ivec2(last, 0)), depth_at(first + ivec2(0, last))) - corner) / float(last);
  Block block = Block(slope, corner, corner);
  for (int i = 0; i < kBlockTexels * kBlockTexels; ++i) {
    ivec2 from_first = ivec2(i % kBlockTexels, i / kBlockTexels);
    float above_slope = depth_at(first + from_first) - dot(slope, vec2(from_first));
    block.least = min(block.least, above_slope);
    block.largest = max(block.largest, above_slope);
  }
  out_blocks = pack(block);
}

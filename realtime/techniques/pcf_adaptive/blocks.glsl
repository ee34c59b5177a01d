// SPDX-License-Identifier: Apache-2.0
// A block of the map: every stored depth in it lies between two parallel planes. Planes of the scene are planes in
// stored depth too, so that a slanted floor is as thin as a level one.
const int kBlockTexels = 16;  // const: as in the size of `blocks` in technique.toml

struct Block {
  vec2 slope;     // of the planes, in depth per texel
  float least;    // their depths at the block's lowest texel
  float largest;
};

vec4 pack(Block block) { return vec4(block.slope, block.least, block.largest); }
Block unpack(vec4 packed_block) { return Block(packed_block.xy, packed_block.z, packed_block.w); }

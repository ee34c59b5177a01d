// SPDX-License-Identifier: Apache-2.0
// Holes of triangles. Twin: scenes/cutouts.h; layout: realtime/harness/cutout_buffers.h.

layout(std430, binding = 3) readonly buffer Cutouts { uint cutout_words[]; };  // const: cutout_buffers.h

uint mask_texel(float at, uint count) { return min(uint((at - floor(at)) * float(count)), count - 1u); }

// Nearest texel of the mask whose words start at `mask`.
bool is_hole(uint mask, vec2 uv) {
  uint width = cutout_words[mask], height = cutout_words[mask + 1u];
  uint texel = mask_texel(uv.y, height) * width + mask_texel(uv.x, width);
  return (cutout_words[mask + 2u + texel / 32u] >> (texel % 32u) & 1u) == 0u;  // const: bits of a word
}

vec2 cutout_uv_of_corner(uint record, uint corner) {
  return uintBitsToFloat(uvec2(cutout_words[record + 2u * corner], cutout_words[record + 2u * corner + 1u]));
}

const uint kRecordWords = 7u;  // const: three corners of two words, and the mask

// `weights`: of the triangle's corners, with sum 1.
bool is_hole_of_record(uint record, vec3 weights) {
  vec2 uv = weights.x * cutout_uv_of_corner(record, 0u) + weights.y * cutout_uv_of_corner(record, 1u) +
            weights.z * cutout_uv_of_corner(record, 2u);
  return is_hole(cutout_words[record + kRecordWords - 1u], uv);
}

bool is_hole_of(uint triangle, vec3 weights) {
  if (triangle < cutout_words[0]) return false;
  return is_hole_of_record(1u + kRecordWords * (triangle - cutout_words[0]), weights);
}

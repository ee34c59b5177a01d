// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles with holes: a mask over their texture coordinates says where. Twin: realtime/shaders/lib/cutout.glsl.

#include <glm/vec2.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace umbrameter {

/// A bit a texel, 1 = solid. Texel (x, y) covers u in [x, x + 1) / width, v in [y, y + 1) / height; it repeats beyond.
struct AlphaMask {
  std::string name;  // of the picture, for people
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint32_t> bits;  // texel y * width + x is bit (index % 32) of word index / 32

  bool is_solid(uint32_t texel) const { return (bits[texel / 32] >> (texel % 32) & 1u) != 0; }
};

/// What a triangle with holes has besides its corners.
struct Cutout {
  std::array<glm::vec2, 3> uv{};  // within +-kMaxUv
  uint32_t mask = 0;              // in Scene::masks
};

/// Texture coordinates stay finer than a texel within this.
inline constexpr float kMaxUv = 4096.0f;
/// Of a texel, for it to be solid.
inline constexpr float kLeastAlpha = 0.5f;

/// Nearest texel, in floats: both renderers take the same steps.
inline bool is_hole(const AlphaMask& mask, const glm::vec2& uv) {
  const auto texel = [](float at, uint32_t count) {
    const auto index = static_cast<uint32_t>((at - std::floor(at)) * static_cast<float>(count));
    return index < count ? index : count - 1;
  };
  return !mask.is_solid(texel(uv.y, mask.height) * mask.width + texel(uv.x, mask.width));
}

/// Where corners b and c weigh `weight_b` and `weight_c`.
inline glm::vec2 uv_at(const Cutout& cutout, float weight_b, float weight_c) {
  return (1.0f - weight_b - weight_c) * cutout.uv[0] + weight_b * cutout.uv[1] + weight_c * cutout.uv[2];
}

}  // namespace umbrameter

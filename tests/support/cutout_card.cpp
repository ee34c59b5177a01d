// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cutout_card.h"

#include "tests/support/procedural_scene.h"

namespace umbrameter {

AlphaMask pattern_mask(std::initializer_list<std::string_view> rows) {
  AlphaMask mask;
  mask.height = static_cast<uint32_t>(rows.size());
  mask.width = static_cast<uint32_t>(rows.begin()->size());
  mask.bits.resize((size_t{mask.width} * mask.height + 31) / 32, 0);
  uint32_t y = mask.height;
  for (const std::string_view row : rows) {
    --y;
    for (uint32_t x = 0; x < mask.width; ++x) {
      const uint32_t texel = y * mask.width + x;
      if (row[x] == '#') mask.bits[texel / 32] |= 1u << (texel % 32);
    }
  }
  return mask;
}

double hole_share(const AlphaMask& mask) {
  const uint32_t texels = mask.width * mask.height;
  uint32_t holes = 0;
  for (uint32_t i = 0; i < texels; ++i) holes += mask.is_solid(i) ? 0 : 1;
  return static_cast<double>(holes) / texels;
}

void add_cutout_card(Scene& scene, const AlphaMask& mask, const glm::dvec2& size, double y,
                     double period_world) {
  const size_t first = scene.triangles.size();
  add_floor(scene, size, y);
  for (size_t t = first; t < scene.triangles.size(); ++t) {
    Cutout cutout{{}, static_cast<uint32_t>(scene.masks.size())};
    for (int c = 0; c < 3; ++c) {
      const glm::dvec3 p(scene.positions_world[scene.triangles[t][c]]);
      cutout.uv[static_cast<size_t>(c)] = glm::vec2(p.x / period_world, p.z / period_world);
    }
    scene.cutouts.edit().push_back(cutout);
  }
  scene.masks.edit().push_back(mask);
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/camera_tiles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

constexpr int kCellsASide = 16;

/// Planes with the inside at dot(plane, (p, 1)) >= 0: left, right, bottom, top, in front of the eye.
std::array<glm::dvec4, 5> frustum_planes(const glm::dmat4& clip_from_world) {
  const auto row = [&](int i) {
    return glm::dvec4(clip_from_world[0][i], clip_from_world[1][i], clip_from_world[2][i],
                      clip_from_world[3][i]);
  };
  return {row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1), row(3)};
}

bool is_outside(const glm::dvec4& plane, const glm::dvec3& min, const glm::dvec3& max) {
  const glm::dvec3 normal(plane);
  const glm::dvec3 farthest = glm::mix(min, max, glm::greaterThan(normal, glm::dvec3(0.0)));
  return glm::dot(normal, farthest) + plane.w < 0.0;
}

}  // namespace

std::vector<ReceiverTile> camera_tiles(const Scene& scene, int width_px, int height_px) {
  const auto planes = frustum_planes(clip_from_world(scene.camera, width_px, height_px));
  const glm::dvec3 low = scene.bounds_world.min;
  const glm::dvec3 cell = (scene.bounds_world.max - low) / static_cast<double>(kCellsASide);
  std::vector<ReceiverTile> tiles;
  for (int i = 0; i < kCellsASide * kCellsASide * kCellsASide; ++i) {
    const glm::dvec3 index(i % kCellsASide, i / kCellsASide % kCellsASide, i / kCellsASide / kCellsASide);
    const glm::dvec3 min = low + index * cell;
    const glm::dvec3 max = min + cell;
    const auto leaves_out = [&](const glm::dvec4& plane) { return is_outside(plane, min, max); };
    if (std::ranges::any_of(planes, leaves_out)) continue;
    tiles.push_back({glm::vec3(min), glm::vec3(max)});
  }
  return tiles;
}

}  // namespace umbrameter

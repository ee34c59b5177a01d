// SPDX-License-Identifier: Apache-2.0
#include "realtime/scene_data/adjacency.h"

#include "scenes/instances.h"

#include <algorithm>
#include <array>
#include <compare>

namespace umbrameter {
namespace {

using Place = std::array<float, 3>;

/// Side `slot` of all triangles' sides, between two places in a fixed order.
struct Side {
  Place low, high;
  uint32_t slot = 0;

  bool is_between_same(const Side& other) const { return low == other.low && high == other.high; }
  auto operator<=>(const Side&) const = default;
};

/// Adding 0 makes one zero of both.
Place place_of(const glm::vec3& p) {
  return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

std::vector<Side> sides_of(const SharedList<glm::vec3>& positions, const SharedList<glm::uvec3>& triangles,
                           uint32_t first_slot) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  uint32_t slot = first_slot;
  for (const glm::uvec3& triangle : triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      Place from = place_of(positions[triangle[corner]]);
      Place to = place_of(positions[triangle[(corner + 1) % 3]]);
      if (to < from) std::swap(from, to);
      sides.push_back({from, to, slot++});
    }
  }
  return sides;
}

void join(const Side& one, const Side& other, std::vector<uint32_t>& neighbours) {
  neighbours[one.slot] = other.slot / 3;
  neighbours[other.slot] = one.slot / 3;
}

void add_neighbours(std::vector<Side> sides, std::vector<uint32_t>& neighbours) {
  std::ranges::sort(sides);
  for (auto first = sides.begin(); first != sides.end();) {
    const auto end =
        std::find_if(first, sides.end(), [&](const Side& side) { return !side.is_between_same(*first); });
    if (end - first == 2) join(*first, *(first + 1), neighbours);
    first = end;
  }
}

}  // namespace

std::vector<uint32_t> triangle_neighbours(const Scene& scene) {
  size_t triangles = scene.triangles.size();
  for (const auto& mesh : scene.instanced) triangles += mesh->triangles.size();
  std::vector<uint32_t> neighbours(3 * triangles, kNoNeighbour);
  add_neighbours(sides_of(scene.positions_world, scene.triangles, 0), neighbours);
  auto first = static_cast<uint32_t>(scene.triangles.size());
  for (const auto& mesh : scene.instanced) {
    add_neighbours(sides_of(mesh->positions, mesh->triangles, 3 * first), neighbours);
    first += static_cast<uint32_t>(mesh->triangles.size());
  }
  return neighbours;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which triangles a convex volume may meet: the oracle's own tree, so that it owes nothing to what it judges.

#include "scenes/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// Keeps the points q with normal . (q - origin) >= 0.
struct KeptSide {
  glm::dvec3 origin_world{0.0};
  glm::dvec3 normal_world{0.0};
};

class TriangleTree {
 public:
  /// Keeps a reference to `scene`.
  explicit TriangleTree(const Scene& scene);

  const Scene& scene() const { return scene_; }
  /// Greatest coordinate of the scene: what rounding scales with.
  double extent_world() const { return extent_world_; }
  /// All triangles that the volume kept by `sides` meets, and some that it only nearly meets: those that have no
  /// corner within 1e-14 of the extent of some side's kept half are left out.
  std::vector<uint32_t> near(std::span<const KeptSide> sides) const;
  /// Corners as ids of places: equal for equal positions, whatever the mesh calls them.
  glm::uvec3 places(uint32_t triangle) const;

 private:
  struct Node {
    std::array<float, 3> min, max;
    uint32_t first =
        0;  // a leaf's triangles in order_, an inner node's second child; its first child is next
    uint32_t count = 0;  // 0: an inner node
  };
  void build(uint32_t first, uint32_t count);
  void weld();

  const Scene& scene_;
  double extent_world_ = 0.0;
  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;
  std::vector<uint32_t> place_of_vertex_;
};

}  // namespace umbrameter

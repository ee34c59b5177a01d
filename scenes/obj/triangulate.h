// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons to triangles.

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

struct Triangulation {
  std::vector<std::array<uint32_t, 3>> triangles;  // indices of corners, oriented like the polygon
  size_t equal_neighbours = 0;                     // corners left out, being where the corner before them is
  bool is_guess = false;                           // no ear was left: the polygon crosses itself
};

/// Splits a polygon, given by its corners in order, by clipping ears in the plane of its Newell normal (Meisters,
/// "Polygons have ears", 1975). The triangles cover the polygon once when its edges do not cross; they may touch
/// or coincide, as the two sides of a bridge to a hole do. Three corners are returned as they are. A triangle has
/// no area where the corners it needs lie on one line. Time: O(corners x reflex corners) at worst.
Triangulation triangulate(std::span<const glm::dvec3> corners);

}  // namespace umbrameter

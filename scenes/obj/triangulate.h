// SPDX-License-Identifier: Apache-2.0
#pragma once
// Polygons to triangles.

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace umbrameter {

/// Splits a simple polygon, given by its corners in order, into corners - 2 triangles of the same
/// orientation, by clipping ears in the plane of its Newell normal. A polygon without area, or one that
/// crosses itself, still gives corners - 2 triangles.
std::vector<std::array<uint32_t, 3>> triangulate(std::span<const glm::dvec3> corners);

}  // namespace umbrameter

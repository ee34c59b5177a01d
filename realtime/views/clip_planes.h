// SPDX-License-Identifier: Apache-2.0
#pragma once
// What GL clips away, told from boxes around it, before any vertex is fetched. Internal to views/.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <vector>

namespace umbrameter {

/// Nothing with dot(plane, (p_world, 1)) < 0 at all its points is drawn.
using ClipPlanes = std::vector<glm::dvec4>;

/// w >= 0, -w <= x <= w, -w <= y <= w, and with clipped depth 0 <= z <= w.
ClipPlanes clip_planes(const glm::dmat4& clip_from_world, bool clamps_depth);

/// Whether all of the box is behind the plane, by more than GL's floats may be off.
bool is_behind(const glm::dvec4& plane, const glm::vec3& min_world, const glm::vec3& max_world);

inline bool is_clipped(const ClipPlanes& planes, const glm::vec3& min_world, const glm::vec3& max_world) {
  return std::ranges::any_of(planes,
                             [&](const glm::dvec4& plane) { return is_behind(plane, min_world, max_world); });
}

}  // namespace umbrameter

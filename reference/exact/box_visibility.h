// SPDX-License-Identifier: Apache-2.0
#pragma once
// Visibility behind a single box in closed form: polygons clipped in double precision. No CGAL.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace umbrameter {

/// A closed axis-aligned box under a rectangular light that lies at one height and faces straight down.
struct BoxUnderLight {
  glm::dvec3 box_min_world{0.0};
  glm::dvec3 box_max_world{0.0};
  glm::dvec3 light_center_world{0.0};
  glm::dvec2 light_size_xz_world{0.0};
};

/// The part of the light's area that the point `p_world` of a surface with normal `n_world` sees, to about 1e-14. The
/// point lies below the light, on or outside the box; within 1e-6 of a face's plane it counts as in it.
double box_visibility(const BoxUnderLight& scene, const glm::dvec3& p_world, const glm::dvec3& n_world);

}  // namespace umbrameter

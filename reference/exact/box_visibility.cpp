// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/box_visibility.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace umbrameter {

namespace {

using Corners = std::vector<glm::dvec3>;

/// Keeps what lies where normal . (q - origin) >= 0 (Sutherland and Hodgman).
Corners clip(const Corners& corners, const glm::dvec3& origin, const glm::dvec3& normal) {
  Corners kept;
  for (size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& from = corners[i];
    const glm::dvec3& to = corners[(i + 1) % corners.size()];
    const double at_from = glm::dot(normal, from - origin);
    const double at_to = glm::dot(normal, to - origin);
    if (at_from >= 0.0) kept.push_back(from);
    if (at_from * at_to < 0.0) kept.push_back(from + (to - from) * (at_from / (at_from - at_to)));
  }
  return kept;
}

double area_xz(const Corners& corners) {
  double twice = 0.0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& a = corners[i];
    const glm::dvec3& b = corners[(i + 1) % corners.size()];
    twice += a.x * b.z - a.z * b.x;
  }
  return 0.5 * std::abs(twice);
}

Corners rectangle_of(const BoxUnderLight& scene) {
  const glm::dvec3 x{0.5 * scene.light_size_xz_world.x, 0, 0};
  const glm::dvec3 z{0, 0, 0.5 * scene.light_size_xz_world.y};
  const glm::dvec3& c = scene.light_center_world;
  return {c - x - z, c + x - z, c + x + z, c - x + z};
}

/// The face on side `side` (0 low, 1 high) of `axis`.
Corners face_of(const BoxUnderLight& scene, int axis, int side) {
  const std::array<glm::dvec3, 2> ends{scene.box_min_world, scene.box_max_world};
  Corners corners(4);
  for (size_t k = 0; k < 4; ++k) {
    corners[k][axis] = ends[static_cast<size_t>(side)][axis];
    corners[k][(axis + 1) % 3] = ends[k == 1 || k == 2 ? 1 : 0][(axis + 1) % 3];
    corners[k][(axis + 2) % 3] = ends[k >= 2 ? 1 : 0][(axis + 2) % 3];
  }
  return corners;
}

/// The area of the light that the face hides: the part of it inside the pyramid from `p` over the light above the
/// receiver's horizon, projected onto the light.
double hidden_by(const Corners& face, const glm::dvec3& p, const Corners& light) {
  Corners part = face;
  for (size_t k = 0; k < light.size(); ++k) {
    glm::dvec3 inwards = glm::cross(light[k] - p, light[(k + 1) % light.size()] - p);
    if (glm::dot(inwards, light[(k + 2) % light.size()] - p) < 0.0) inwards = -inwards;
    part = clip(part, p, inwards);
  }
  for (glm::dvec3& q : part) q = p + (q - p) * ((light[0].y - p.y) / (q.y - p.y));
  return area_xz(part);
}

}  // namespace

double box_visibility(const BoxUnderLight& scene, const glm::dvec3& p_world, const glm::dvec3& n_world) {
  constexpr double kOnFace = 1e-6;
  const Corners light = rectangle_of(scene);
  const Corners above = clip(light, p_world, n_world);
  if (above.size() < 3) return 0.0;
  double seen = area_xz(above);
  // The shadows of the faces that look at p lie side by side: a box is convex.
  for (int axis = 0; axis < 3; ++axis) {
    if (p_world[axis] < scene.box_min_world[axis] - kOnFace)
      seen -= hidden_by(face_of(scene, axis, 0), p_world, above);
    if (p_world[axis] > scene.box_max_world[axis] + kOnFace)
      seen -= hidden_by(face_of(scene, axis, 1), p_world, above);
  }
  return std::max(0.0, seen) / area_xz(light);
}

}  // namespace umbrameter

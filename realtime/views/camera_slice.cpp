// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/camera_slice.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// Tangents of the frustum's half angles, across and up.
glm::dvec2 half_tangents(const Camera& camera, const glm::ivec2& screen_px) {
  const double up = std::tan(0.5 * glm::radians(camera.vertical_fov_deg));
  return {up * screen_px.x / screen_px.y, up};
}

}  // namespace

std::array<glm::dvec3, 8> corners_world(const Camera& camera, const glm::ivec2& screen_px,
                                        const CameraSlice& slice) {
  const glm::dmat4 world_from_view = glm::inverse(view_from_world(camera));
  const glm::dvec2 half = half_tangents(camera, screen_px);
  std::array<glm::dvec3, 8> corners;
  for (size_t i = 0; i < corners.size(); ++i) {
    const double z = (i & 4) != 0 ? slice.far_world : slice.near_world;
    const glm::dvec2 corner((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0);
    corners[i] = glm::dvec3(world_from_view * glm::dvec4(z * half * corner, -z, 1.0));
  }
  return corners;
}

Sphere sphere_around(const Camera& camera, const glm::ivec2& screen_px, const CameraSlice& slice) {
  // A middle at distance m is as far from the near quad as from the far one where
  // (m - n)^2 + (n t)^2 = (f - m)^2 + (f t)^2, t the tangent of the corners; beyond the far quad that one decides.
  const glm::dvec2 half = half_tangents(camera, screen_px);
  const double tangent2 = glm::dot(half, half);
  const double even = 0.5 * (slice.near_world + slice.far_world) * (1.0 + tangent2);
  const double middle = std::min(even, slice.far_world);
  const glm::dvec3 forward = glm::normalize(camera.at_world - camera.eye_world);
  const double beyond = slice.far_world - middle;
  const double half_diagonal2 = slice.far_world * slice.far_world * tangent2;
  return {camera.eye_world + middle * forward, std::sqrt(beyond * beyond + half_diagonal2)};
}

}  // namespace umbrameter

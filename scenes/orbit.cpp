// SPDX-License-Identifier: Apache-2.0
#include "scenes/orbit.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace umbrameter {

Camera orbit(const Camera& camera, double angle_deg) {
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  const glm::dvec3 axis = glm::normalize(camera.up_world);
  const glm::dvec3 arm = camera.eye_world - camera.at_world;
  const glm::dvec3 along = glm::dot(arm, axis) * axis;
  const glm::dvec3 across = arm - along;
  Camera moved = camera;
  moved.eye_world =
      camera.at_world + along + std::cos(angle_rad) * across + std::sin(angle_rad) * glm::cross(axis, across);
  return moved;
}

}  // namespace umbrameter

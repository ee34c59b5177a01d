// SPDX-License-Identifier: Apache-2.0
#include "scenes/rotation.h"

#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>

namespace umbrameter {
namespace {

/// Cosine and sine.
glm::dvec2 circle_deg(double angle_deg) {
  const double quarters = angle_deg / 90.0;
  if (quarters == std::floor(quarters)) {
    constexpr std::array<std::array<double, 2>, 4> kExact = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto& [cosine, sine] = kExact[static_cast<size_t>(quarters - 4.0 * std::floor(quarters / 4.0))];
    return {cosine, sine};
  }
  const double angle_rad = glm::radians(angle_deg);
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

}  // namespace

glm::dmat3 rotation(const glm::dvec3& axis, double angle_deg) {
  // Rodrigues.
  const glm::dvec2 circle = circle_deg(angle_deg);
  const glm::dmat3 cross(glm::dvec3(0, axis.z, -axis.y), glm::dvec3(-axis.z, 0, axis.x),
                         glm::dvec3(axis.y, -axis.x, 0));
  return circle.x * glm::dmat3(1.0) + circle.y * cross + (1.0 - circle.x) * glm::outerProduct(axis, axis);
}

}  // namespace umbrameter

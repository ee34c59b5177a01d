// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/light_outline.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

constexpr int kCorners = 512;

std::vector<glm::dvec2> regular_polygon(double radius) {
  std::vector<glm::dvec2> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kCorners;
    corners.push_back(radius * glm::dvec2(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return corners;
}

LightOutline round_outline(PolygonLight frame, double radius) {
  LightOutline outline;
  frame.corners = regular_polygon(radius);
  outline.polygon = std::move(frame);
  outline.outer = regular_polygon(radius / std::cos(std::numbers::pi / kCorners));
  outline.area = std::numbers::pi * radius * radius;
  return outline;
}

/// A disk around `center_world` that faces `p_world`.
PolygonLight frame_facing(const glm::dvec3& center_world, const glm::dvec3& p_world) {
  const glm::dvec3 direction = glm::normalize(p_world - center_world);
  const glm::dvec3 helper = std::abs(direction.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 tangent = glm::normalize(glm::cross(helper, direction));
  return {center_world, tangent, glm::cross(direction, tangent), direction, {}};
}

}  // namespace

LightOutline outline_of(const Light& light, const glm::dvec3& p_world, double beyond_world) {
  switch (light.type) {
    case LightType::rect: {
      LightOutline outline;
      outline.polygon = rectangle_light(light.center_world, light.tangent_world, light.bitangent_world,
                                        light.direction_world, light.size_world);
      outline.outer = outline.polygon.corners;
      outline.area = light.size_world.x * light.size_world.y;
      outline.is_one_sided = outline.is_flat = true;
      return outline;
    }
    case LightType::disk: {
      LightOutline outline = round_outline(
          {light.center_world, light.tangent_world, light.bitangent_world, light.direction_world, {}},
          light.radius_world);
      outline.is_one_sided = outline.is_flat = true;
      return outline;
    }
    case LightType::sphere: {
      const double sine = light.radius_world / glm::distance(light.center_world, p_world);
      if (!(sine < 1.0)) return {};
      return round_outline(frame_facing(light.center_world, p_world),
                           light.radius_world / std::sqrt(1.0 - sine * sine));
    }
    case LightType::sun:
      break;
  }
  return round_outline(frame_facing(p_world - light.direction_world * beyond_world, p_world),
                       beyond_world * std::tan(light.half_angle_rad));
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "lab/causes/light_parts.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

constexpr int kParts = kLightPartsPerSide * kLightPartsPerSide;

/// Of the rect: in its half extents.
glm::dvec2 tile_center(int index) {
  const glm::dvec2 place(index % kLightPartsPerSide, index / kLightPartsPerSide);
  return (2.0 * place + 1.0) / static_cast<double>(kLightPartsPerSide) - 1.0;
}

/// Vogel's spiral on the unit disk.
glm::dvec2 disk_center(int index) {
  const double golden_rad = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt((index + 0.5) / kParts);
  return radius * glm::dvec2(std::cos(index * golden_rad), std::sin(index * golden_rad));
}

Light turned_to(Light light, const glm::dvec3& direction_world) {
  const glm::dvec3 d_world = glm::normalize(direction_world);
  light.direction_world = d_world;
  light.tangent_world =
      glm::normalize(light.tangent_world - glm::dot(light.tangent_world, d_world) * d_world);
  light.bitangent_world = glm::cross(d_world, light.tangent_world);
  return light;
}

Light part_of(const Light& light, int index) {
  Light part = light;
  const double share = 1.0 / kLightPartsPerSide;
  const glm::dvec2 place = light.type == LightType::rect ? tile_center(index) : disk_center(index);
  const auto offset = [&](const glm::dvec2& extent) {
    return extent.x * place.x * light.tangent_world + extent.y * place.y * light.bitangent_world;
  };
  switch (light.type) {
    case LightType::rect:
      part.center_world += offset(0.5 * light.size_world);
      part.size_world *= share;
      return part;
    case LightType::disk:
    case LightType::sphere:
      part.center_world += offset(glm::dvec2(light.radius_world));
      part.radius_world *= share;
      return part;
    case LightType::sun:
      break;
  }
  part.half_angle_rad *= share;
  return turned_to(part, light.direction_world + offset(glm::dvec2(std::tan(light.half_angle_rad))));
}

}  // namespace

std::vector<Light> light_parts(const Light& light) {
  std::vector<Light> parts;
  for (int index = 0; index < kParts; ++index) parts.push_back(part_of(light, index));
  return parts;
}

}  // namespace umbrameter

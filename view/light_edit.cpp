// SPDX-License-Identifier: Apache-2.0
#include "view/light_edit.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr double kMinSine = 1e-3;  // of the angle between a tangent and the direction

/// The first of them that is not parallel to `direction`, made perpendicular to it.
dvec3 tangent_near(const dvec3& wanted, const dvec3& direction) {
  for (const dvec3& candidate : {wanted, glm::cross(direction, dvec3(0, 1, 0)), dvec3(1, 0, 0)}) {
    const dvec3 across = candidate - direction * glm::dot(candidate, direction);
    if (glm::length(across) > kMinSine) return glm::normalize(across);
  }
  return {0, 0, 1};
}

}  // namespace

Light facing(Light light, const dvec3& direction_world) {
  light.direction_world = glm::normalize(direction_world);
  light.tangent_world = tangent_near(light.tangent_world, light.direction_world);
  light.bitangent_world = glm::cross(light.direction_world, light.tangent_world);
  return light;
}

Light at_camera(Light light, const Camera& camera) {
  if (light.type != LightType::sun) light.center_world = camera.eye_world;
  return facing(std::move(light), camera.at_world - camera.eye_world);
}

Light swung(Light light, const Camera& camera, double yaw_rad, double pitch_rad) {
  const dvec3 right = glm::cross(camera.at_world - camera.eye_world, camera.up_world);
  const glm::dquat turn =
      glm::angleAxis(yaw_rad, camera.up_world) * glm::angleAxis(-pitch_rad, glm::normalize(right));
  light.center_world = camera.at_world + turn * (light.center_world - camera.at_world);
  return facing(std::move(light), turn * light.direction_world);
}

Light resized(Light light, double factor) {
  light.size_world *= factor;
  light.radius_world *= factor;
  const double least_rad = glm::radians(1e-6) / 2, most_rad = glm::radians(90.0) / 2;
  if (light.type == LightType::sun)
    light.half_angle_rad = std::clamp(light.half_angle_rad * factor, least_rad, most_rad);
  return light;
}

}  // namespace umbrameter

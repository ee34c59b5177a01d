// SPDX-License-Identifier: Apache-2.0
#include "view/camera_control.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using glm::dvec3;

const double kPoleGap_rad = glm::radians(2.0);

/// `direction` turned to the right about `up`, and up by `pitch_rad` as far as the pole allows.
dvec3 turned(const dvec3& direction, const dvec3& up, double yaw_rad, double pitch_rad) {
  const double from_up_rad = std::acos(std::clamp(glm::dot(glm::normalize(direction), up), -1.0, 1.0));
  const double wanted_rad =
      std::clamp(from_up_rad - pitch_rad, kPoleGap_rad, glm::radians(180.0) - kPoleGap_rad);
  const dvec3 right = glm::normalize(glm::cross(direction, up));
  const glm::dquat pitch = glm::angleAxis(from_up_rad - wanted_rad, right);
  return glm::angleAxis(-yaw_rad, up) * (pitch * direction);
}

}  // namespace

Camera looked_around(Camera camera, double yaw_rad, double pitch_rad) {
  camera.at_world =
      camera.eye_world + turned(camera.at_world - camera.eye_world, camera.up_world, yaw_rad, pitch_rad);
  return camera;
}

Camera orbited(Camera camera, double yaw_rad, double pitch_rad) {
  camera.eye_world =
      camera.at_world - turned(camera.at_world - camera.eye_world, camera.up_world, yaw_rad, pitch_rad);
  return camera;
}

Camera flown(Camera camera, const dvec3& steps_world) {
  const dvec3 forward = glm::normalize(camera.at_world - camera.eye_world);
  const dvec3 right = glm::normalize(glm::cross(forward, camera.up_world));
  const dvec3 step =
      right * steps_world.x + glm::cross(right, forward) * steps_world.y + forward * steps_world.z;
  camera.eye_world += step;
  camera.at_world += step;
  return camera;
}

Camera dollied(Camera camera, double factor) {
  camera.eye_world = camera.at_world + (camera.eye_world - camera.at_world) * factor;
  return camera;
}

Camera between(const Camera& from, const Camera& to, double share) {
  Camera camera = from;
  camera.eye_world = glm::mix(from.eye_world, to.eye_world, share);
  camera.at_world = glm::mix(from.at_world, to.at_world, share);
  camera.up_world = glm::normalize(glm::mix(from.up_world, to.up_world, share));
  camera.vertical_fov_deg = glm::mix(from.vertical_fov_deg, to.vertical_fov_deg, share);
  return camera;
}

}  // namespace umbrameter

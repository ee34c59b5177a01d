// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_camera.h"

#include "scenes/read_values.h"

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

constexpr double kMinUpSine = 1e-6;  // of the angle between up and the view direction

double read_fov_deg(TomlReader& reader) {
  const double fov_deg = reader.number("fov_deg", Camera{}.vertical_fov_deg);
  if (fov_deg > 0.0 && fov_deg < 180.0) return fov_deg;
  reader.fail("fov_deg", fmt::format("'fov_deg' = {} must lie between 0 and 180 degrees", fov_deg),
              "it is the vertical field of view");
}

}  // namespace

Camera read_camera(const TomlNode& table) {
  TomlReader reader(table, "[camera]");
  Camera camera;
  camera.eye_world = read_point(reader, "eye");
  camera.at_world = read_point(reader, "at");
  camera.up_world = read_unit_vector(reader, "up", camera.up_world);
  camera.vertical_fov_deg = read_fov_deg(reader);
  camera.near_world = read_length(reader, "near", 0.0);
  reader.finish();
  const glm::dvec3 view = camera.at_world - camera.eye_world;
  const double distance = glm::length(view);
  if (distance < kMinLength_world) {
    reader.fail("at", fmt::format("the camera stands on its target {}", to_text(camera.at_world)),
                "'eye' and 'at' must differ");
  }
  if (glm::length(glm::cross(view / distance, camera.up_world)) < kMinUpSine) {
    reader.fail("up", fmt::format("'up' = {} is parallel to the view direction", to_text(camera.up_world)),
                "for a view straight down choose up = [0, 0, -1]");
  }
  return camera;
}

}  // namespace umbrameter

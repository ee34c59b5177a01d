// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_text.h"

#include "core/toml_text.h"
#include "scenes/read_light.h"

#include <glm/trigonometric.hpp>

namespace umbrameter {

std::string camera_keys(const Camera& camera) {
  std::string text = fmt::format("eye = {}\nat = {}\nup = {}\nfov_deg = {}\n", toml_vector(camera.eye_world),
                                 toml_vector(camera.at_world), toml_vector(camera.up_world),
                                 toml_number(camera.vertical_fov_deg));
  if (camera.near_world != 0.0) text += fmt::format("near = {}\n", toml_number(camera.near_world));
  return text;
}

std::string light_keys(const Light& light) {
  std::string text;
  if (!light.name.empty()) text += fmt::format("name = {}\n", toml_string(light.name));
  text += fmt::format("type = {}\n", toml_string(to_text(light.type)));
  if (light.type != LightType::sun) text += fmt::format("center = {}\n", toml_vector(light.center_world));
  text += fmt::format("direction = {}\n", toml_vector(light.direction_world));
  if (light.tangent_world != default_tangent(light.direction_world))
    text += fmt::format("tangent = {}\n", toml_vector(light.tangent_world));
  switch (light.type) {
    case LightType::rect:
      return text + fmt::format("size = [{}, {}]\n", toml_number(light.size_world.x),
                                toml_number(light.size_world.y));
    case LightType::disk:
    case LightType::sphere:
      return text + fmt::format("radius = {}\n", toml_number(light.radius_world));
    case LightType::sun:
      return text + fmt::format("angular_diameter_deg = {}\n",
                                toml_number(2.0 * glm::degrees(light.half_angle_rad)));
  }
  return text;
}

}  // namespace umbrameter

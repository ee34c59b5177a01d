// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_motion.h"

#include "core/names.h"
#include "scenes/read_values.h"

#include <glm/trigonometric.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

void read_object(TomlReader& reader, const Scene& scene, Motion& motion) {
  if (!reader.has("object")) {
    if (reader.has("object_step"))
      reader.fail("object_step", "which object moves is not said", "add 'object'");
    return;
  }
  motion.object = reader.text("object");
  motion.object_step_world = read_point(reader, "object_step");
  std::vector<std::string> names;
  for (const MeshPart& part : scene.parts) names.push_back(part.name);
  if (std::ranges::find(names, motion.object) == names.end())
    reader.fail("object", fmt::format("no mesh that can move is called '{}'", motion.object),
                suggest_name(motion.object, names));
}

void read_light_steps(TomlReader& reader, const Scene& scene, Motion& motion) {
  const auto is_sun = [](const Light& light) { return light.type == LightType::sun; };
  motion.light_step_world = read_point(reader, "light_step", glm::dvec3(0.0));
  motion.sun_step_rad = glm::radians(reader.number("sun_step_deg", 0.0));
  if (reader.has("light_step") && std::ranges::all_of(scene.lights, is_sun))
    reader.fail("light_step", "a sun has no place to move from", "turn it with 'sun_step_deg'");
  if (reader.has("sun_step_deg") && std::ranges::none_of(scene.lights, is_sun))
    reader.fail("sun_step_deg", "the scene has no sun to turn", "move its light with 'light_step'");
}

}  // namespace

Motion read_motion(const TomlNode& table, const Scene& scene) {
  TomlReader reader(table, "[motion]");
  Motion motion{.name = "script"};
  motion.camera_step_world = read_point(reader, "camera_step", glm::dvec3(0.0));
  motion.is_cut = reader.boolean("cut", false);
  read_light_steps(reader, scene, motion);
  read_object(reader, scene, motion);
  reader.finish();
  const glm::dvec3 still(0.0);
  const bool moves = motion.is_cut || motion.camera_step_world != still || motion.light_step_world != still ||
                     motion.sun_step_rad != 0.0 || motion.object_step_world != still;
  if (!moves)
    fail_input("the motion moves nothing", table.where,
               "camera_step, light_step, sun_step_deg, object with object_step, or cut = true");
  return motion;
}

}  // namespace umbrameter

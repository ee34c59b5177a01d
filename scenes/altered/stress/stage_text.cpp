// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/stage_text.h"

#include "core/toml_text.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

glm::dvec3 placed(const StageScene& stage, const glm::dvec3& p_world) {
  return stage.offset_world + stage.scale * p_world;
}

std::string camera_text(const StageScene& stage) {
  std::string text =
      fmt::format("[camera]\neye = {}\nat = {}\nup = {}\nfov_deg = {:.17g}\n",
                  toml_vector(placed(stage, stage.eye_world)), toml_vector(placed(stage, stage.at_world)),
                  toml_vector(stage.up_world), stage.vertical_fov_deg);
  if (stage.near_world) text += fmt::format("near = {:.17g}\n", *stage.near_world * stage.scale);
  return text;
}

std::string light_text(const StageScene& stage) {
  std::string text = fmt::format("[[light]]\ntype = \"{}\"\n", stage.light_type);
  const double size_world = stage.light_size_world * stage.scale;
  if (stage.light_type == "sun") {
    text += fmt::format("angular_diameter_deg = {:.17g}\n", stage.sun_diameter_deg);
  } else {
    text += fmt::format("center = {}\n", toml_vector(placed(stage, stage.light_center_world)));
  }
  if (stage.light_type == "rect") text += fmt::format("size = [{:.17g}, {:.17g}]\n", size_world, size_world);
  if (stage.light_type == "disk" || stage.light_type == "sphere")
    text += fmt::format("radius = {:.17g}\n", 0.5 * size_world);
  const bool has_at = stage.light_at_world && stage.light_type != "sun";
  return text + (has_at ? fmt::format("at = {}\n", toml_vector(placed(stage, *stage.light_at_world)))
                        : fmt::format("direction = {}\n", toml_vector(stage.light_direction_world)));
}

}  // namespace

StageMesh stage_floor() {
  return {"shape = \"plane\"\nsize = [8, 8]\n"};
}

StageMesh stage_box() {
  return {"shape = \"box\"\nsize = [1, 1, 1]\n"};
}

StageMesh stage_slab() {
  return {"shape = \"plate\"\nsize = [0.7, 0.7]\nthickness = 0.1\n", {1.25, 1.2, 0.4}};
}

StageScene nominal_stage() {
  StageScene stage;
  stage.meshes = {stage_floor(), stage_box(), stage_slab()};
  return stage;
}

std::string to_toml(const StageScene& stage) {
  std::string text = camera_text(stage) + light_text(stage);
  for (const StageMesh& mesh : stage.meshes) {
    text += fmt::format("[[mesh]]\n{}scale = {:.17g}\ntranslate = {}\n", mesh.keys, stage.scale,
                        toml_vector(placed(stage, mesh.translate_world)));
  }
  return text + stage.more;
}

StressPoint point_of(const StageScene& stage) {
  return {.scene = to_toml(stage),
          .files = {},
          .assignments = {"map_size=512", "light_samples=16"},
          .edits = {},
          .active_light = 0,
          .must_be_refused = false};
}

}  // namespace umbrameter

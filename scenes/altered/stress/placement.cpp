// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/axes.h"
#include "scenes/altered/stress/stage_text.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

// Along x and z: floats lose the floor's detail, not its height.
StressPoint offset_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.offset_world = value.number * glm::dvec3(1.0, 0.0, 0.7);
  return point_of(stage);
}

StressPoint scale_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.scale = value.number;
  return point_of(stage);
}

// The farthest corner of the floor lies about 9 from the camera.
StressPoint near_far_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.near_world = 9.0 / value.number;
  return point_of(stage);
}

StressPoint floor_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.meshes[0].keys = "shape = \"plane\"\nsize = [" + value.text + ", " + value.text + "]\n";
  return point_of(stage);
}

// A caster ever nearer to the light, while the floor stays where it is.
StressPoint caster_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_center_world = {0, 4, 0};
  stage.light_size_world = 1e-6;
  const double width =
      0.2 * value.number;  // about a tenth of a radian to either side, as seen from the light
  stage.meshes.push_back(
      {fmt::format("shape = \"plate\"\nsize = [{0:.17g}, {0:.17g}]\n", width), {0, 4 - value.number, 0}});
  return point_of(stage);
}

}  // namespace

std::vector<StressAxis> placement_axes() {
  return {
      {.name = "world_offset",
       .unit = "world",
       .doc = "The whole scene, 8 wide, this far from the origin.",
       .values = numbers({0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}),
       .needs_parameter = {},
       .point = offset_point},
      {.name = "scene_scale",
       .unit = "1",
       .doc = "The whole scene, light and camera included, this many times as large.",
       .values = numbers({1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}),
       .nominal = 6,
       .needs_parameter = {},
       .point = scale_point},
      {.name = "near_far",
       .unit = "1",
       .doc = "Distance of the scene's far end over the camera's near plane.",
       .values = numbers({1e1, 1e2, 1e3, 1e4, 1e5, 1e6}),
       .nominal = 2,
       .needs_parameter = {},
       .point = near_far_point},
      {.name = "floor_size",
       .unit = "world",
       .doc = "Side of the floor's two triangles, under a scene that stays as it is.",
       .values = numbers({8, 1e2, 1e3, 1e4, 1e5, 1e6, 1e8}),
       .needs_parameter = {},
       .point = floor_point},
      {.name = "caster_distance",
       .unit = "world",
       .doc = "A plate this far below a light 4 above the floor, always as wide as seen from the light.",
       .values = numbers({1, 3e-1, 1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4}),
       .needs_parameter = {},
       .point = caster_point},
  };
}

}  // namespace umbrameter

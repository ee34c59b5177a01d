// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/axes.h"
#include "scenes/altered/stress/stage_text.h"

namespace umbrameter {
namespace {

StressPoint fov_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.vertical_fov_deg = value.number;
  stage.at_world = {0.62, 0, 0.62};  // a penumbra before the box
  StressPoint point = point_of(stage);
  point.must_be_refused = value.number <= 0.0 || value.number >= 180.0;
  return point;
}

StressPoint camera_height_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.eye_world = {2.6, value.number, 3.6};
  stage.at_world = {0.2, value.number, 0};
  return point_of(stage);
}

StageScene placed_camera(const std::string& place) {
  StageScene stage = nominal_stage();
  if (place == "straight down") {
    stage.eye_world = {0.2, 6, 0.3};
    stage.at_world = {0.2, 0, 0.3};
    stage.up_world = {0, 0, -1};
  }
  if (place == "straight at a wall") {
    stage.eye_world = {0, 0.5, 3};
    stage.at_world = {0, 0.5, 0};
  }
  if (place == "at a vertex") {
    stage.eye_world = {0.5, 1, 0.5};
    stage.at_world = {1.5, 0, 1.5};
  }
  if (place == "on an edge") {
    stage.eye_world = {0.5, 1, 0.1};
    stage.at_world = {2.5, 0, 0.1};
  }
  if (place == "inside a box") {
    stage.eye_world = {0, 0.5, 0};
    stage.at_world = {0.4, 0.3, 0.4};
  }
  if (place == "in the light") {
    stage.eye_world = stage.light_center_world;
    stage.at_world = {0, 0, 0};
  }
  if (place == "at the sky") stage.at_world = {2.6, 9, 3.5};
  if (place == "on its target") stage.at_world = stage.eye_world;
  if (place == "along its up") stage.at_world = stage.eye_world - glm::dvec3(0, 1, 0);
  return stage;
}

StressPoint camera_place_point(const StressValue& value) {
  StressPoint point = point_of(placed_camera(value.text));
  point.must_be_refused = value.text == "on its target" || value.text == "along its up";
  return point;
}

}  // namespace

std::vector<StressAxis> camera_axes() {
  return {
      {.name = "camera",
       .unit = "",
       .doc = "Where the camera stands, or looks.",
       .values = words({"nominal", "straight down", "straight at a wall", "in the light", "at a vertex",
                        "on an edge", "inside a box", "at the sky", "on its target", "along its up"}),
       .needs_parameter = {},
       .point = camera_place_point},
      {.name = "camera_height",
       .unit = "world",
       .doc = "Height of a horizontal camera over the floor: 0 sees it edge-on.",
       .values = numbers({2, 1, 0.3, 0.1, 1e-2, 1e-3, 1e-5, 0}),
       .nominal = 1,
       .needs_parameter = {},
       .point = camera_height_point},
      {.name = "fov",
       .unit = "deg",
       .doc = "The camera's vertical field of view.",
       .values = numbers({0, 1e-4, 1e-2, 1, 10, 50, 90, 120, 150, 170, 179, 179.9, 180}),
       .nominal = 5,
       .needs_parameter = {},
       .point = fov_point},
  };
}

}  // namespace umbrameter

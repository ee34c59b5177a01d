// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/axes.h"
#include "scenes/altered/stress/stage_text.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

glm::dvec3 towards_light(double elevation_deg) {
  const double elevation_rad = glm::radians(elevation_deg);
  constexpr double kAzimuth_rad = 2.6;  // from the left and the front: shadows fall in view
  return {std::cos(elevation_rad) * std::cos(kAzimuth_rad), std::sin(elevation_rad),
          std::cos(elevation_rad) * std::sin(kAzimuth_rad)};
}

StressPoint sun_elevation_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_type = "sun";
  stage.light_direction_world = -towards_light(value.number);
  return point_of(stage);
}

// Exactly at 0 the floor lies in the plane that the light looks along, and its middle.
StressPoint rect_elevation_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_center_world = 4.0 * towards_light(value.number);
  return point_of(stage);
}

StressPoint rect_size_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_size_world = value.number;
  StressPoint point = point_of(stage);
  point.must_be_refused = value.number == 0.0;
  return point;
}

StressPoint sphere_size_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_type = "sphere";
  stage.light_size_world = value.number;
  StressPoint point = point_of(stage);
  point.must_be_refused = value.number == 0.0;
  return point;
}

StressPoint sun_angle_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_type = "sun";
  stage.light_direction_world = -towards_light(50.0);
  stage.sun_diameter_deg = value.number;
  StressPoint point = point_of(stage);
  point.must_be_refused = value.number <= 0.0 || value.number > 90.0;
  return point;
}

// Sinks through the box and the floor.
StressPoint light_height_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_center_world = {0.2, 1.0 + value.number, 0.1};
  stage.light_at_world = std::nullopt;
  stage.light_size_world = 0.5;
  return point_of(stage);
}

StressPoint sphere_height_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_type = "sphere";
  stage.light_center_world = {0.2, 1.0 + value.number, 0.1};
  stage.light_at_world = std::nullopt;
  stage.light_size_world = 0.5;
  return point_of(stage);
}

std::string other_light(int i) {
  return fmt::format(
      "[[light]]\nname = \"other {}\"\ntype = \"disk\"\ncenter = [{}, 5, 0]\nat = [0, 0, 0]\nradius = 0.2\n",
      i, 0.1 * i);
}

// Pictures are of the first light.
StressPoint light_count_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  for (int i = 1; i < static_cast<int>(value.number); ++i) stage.more += other_light(i);
  StressPoint point = point_of(stage);
  point.must_be_refused = value.number == 0.0;
  if (point.must_be_refused) {
    const size_t start = point.scene.find("[[light]]");
    point.scene.erase(start, point.scene.find("[[mesh]]") - start);
  }
  return point;
}

// The stage's own light, the one rectangle, moves down the file and must stay what is drawn.
StressPoint light_index_point(const StressValue& value) {
  constexpr int kLights = 64;
  const int index = static_cast<int>(value.number);
  std::string before;
  for (int i = 0; i < index; ++i) before += other_light(i);
  StageScene stage = nominal_stage();
  for (int i = index + 1; i < kLights; ++i) stage.more += other_light(i);
  StressPoint point = point_of(stage);
  point.scene = before + point.scene;
  point.active_light = static_cast<size_t>(index);
  return point;
}

}  // namespace

std::vector<StressAxis> light_axes() {
  return {
      {.name = "sun_elevation",
       .unit = "deg",
       .doc = "Height of the sun over the floor, down to edge-on.",
       .values = numbers({60, 45, 30, 15, 5, 2, 1, 0.5, 0.1, 0}),
       .needs_parameter = {},
       .point = sun_elevation_point},
      {.name = "rect_elevation",
       .unit = "deg",
       .doc = "The same for a rectangle 0.3 wide, 4 away, which faces the middle of the floor.",
       .values = numbers({60, 45, 30, 15, 8, 5, 2, 1, 0.1, 0}),
       .needs_parameter = {},
       .point = rect_elevation_point},
      {.name = "rect_size",
       .unit = "world",
       .doc = "Side of a rectangle 4 above a scene 8 wide.",
       .values = numbers({0, 1e-6, 1e-3, 1e-2, 1e-1, 0.3, 1, 3, 10, 100, 800}),
       .nominal = 5,
       .needs_parameter = {},
       .point = rect_size_point},
      {.name = "sphere_size",
       .unit = "world",
       .doc = "Diameter of a sphere whose centre stays 4 above the floor: the large ones hold the scene.",
       .values = numbers({0, 1e-6, 1e-3, 1e-2, 1e-1, 0.3, 1, 3, 5, 10, 800}),
       .nominal = 5,
       .needs_parameter = {},
       .point = sphere_size_point},
      {.name = "sun_angle",
       .unit = "deg",
       .doc = "Angular diameter of the sun.",
       .values = numbers({0, 1e-6, 1e-3, 0.1, 0.53, 2, 5, 15, 45, 90, 91}),
       .nominal = 4,
       .needs_parameter = {},
       .point = sun_angle_point},
      {.name = "rect_height",
       .unit = "world",
       .doc =
           "Height of a rectangle 0.5 wide over the box's top: touching it, inside the box, below the floor.",
       .values = numbers({3, 1, 0.3, 0.1, 1e-2, 1e-3, 1e-6, 0, -1e-6, -0.5, -1, -2}),
       .needs_parameter = {},
       .point = light_height_point},
      {.name = "sphere_height",
       .unit = "world",
       .doc = "The same for a sphere of diameter 0.5: it cuts the top, then lies inside, then below.",
       .values = numbers({3, 1, 0.3, 0.25, 0.1, 0, -0.1, -0.5, -1, -2}),
       .needs_parameter = {},
       .point = sphere_height_point},
      {.name = "lights",
       .unit = "lights",
       .doc = "Lights in the file; pictures are of the first.",
       .values = numbers({0, 1, 2, 64}),
       .nominal = 1,
       .needs_parameter = {},
       .point = light_count_point},
      {.name = "light_index",
       .unit = "",
       .doc = "Which of 64 lights is drawn: the same one, at this place in the file.",
       .values = numbers({0, 1, 31, 63}),
       .needs_parameter = {},
       .point = light_index_point},
  };
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene that axes change one thing of: a box and a floating slab on a floor under a rectangle, as the text of a scene
// file. Numbers here are before `scale` and `offset_world`.

#include "scenes/altered/stress/axis.h"

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct StageMesh {
  std::string keys;  // of the [[mesh]] but its transform: shape = "box", ...
  glm::dvec3 translate_world{0.0};
};

struct StageScene {
  double scale = 1.0;
  glm::dvec3 offset_world{0.0};
  glm::dvec3 eye_world{2.6, 2.4, 3.6}, at_world{0.2, 0.3, 0};
  glm::dvec3 up_world{0, 1, 0};
  double vertical_fov_deg = 50.0;
  std::optional<double> near_world;

  std::string light_type = "rect";
  glm::dvec3 light_center_world{-1.5, 4, 1};
  std::optional<glm::dvec3> light_at_world = glm::dvec3(0.0);  // else: along light_direction_world
  glm::dvec3 light_direction_world{0, -1, 0};
  double light_size_world = 0.3;  // width of a rect, diameter of a disk or sphere
  double sun_diameter_deg = 2.0;

  std::vector<StageMesh> meshes;
  std::string more;  // further tables, as they are
};

StageMesh stage_floor();
StageMesh stage_box();
StageMesh stage_slab();

/// All three under the default light.
StageScene nominal_stage();

std::string to_toml(const StageScene& stage);

/// The stage with the parameters that keep every technique quick: what an axis starts from.
StressPoint point_of(const StageScene& stage);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/axes.h"
#include "scenes/altered/stress/obj_text.h"
#include "scenes/altered/stress/stage_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

std::string box_keys(double x, double y, double z) {
  return fmt::format("shape = \"box\"\nsize = [{:.17g}, {:.17g}, {:.17g}]\n", x, y, z);
}

// Light on one side, the camera on the other: what leaks through the wall is seen on the floor before it.
StressPoint wall_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.meshes = {stage_floor(), {box_keys(4, 2, value.number), {0, 0, 0}}};
  stage.light_center_world = {0.4, 2.5, -3};
  stage.eye_world = {1.5, 3, 4};
  stage.at_world = {0, 0.4, 0.6};
  return point_of(stage);
}

StressPoint gap_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.meshes[1].translate_world.y = value.number;
  return point_of(stage);
}

StressPoint wire_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.meshes = {stage_floor()};
  for (const double z : {-0.5, 0.0, 0.5}) {
    stage.meshes.push_back(
        {fmt::format("shape = \"wire\"\nradius = {:.17g}\nlength = 3\nsegments = 6\n", value.number),
         {0, 0.5, z}});
  }
  stage.light_size_world = 0.1;
  return point_of(stage);
}

/// The stage with `soup` instead of the slab.
StressPoint with_soup(const TriangleSoup& soup) {
  StageScene stage = nominal_stage();
  stage.meshes[2] = {"file = \"part.obj\"\n"};
  StressPoint point = point_of(stage);
  point.files = {{"part.obj", obj_text(soup)}};
  return point;
}

// A slab of 64 strips whose widths alternate between wide and the value.
StressPoint sliver_point(const StressValue& value) {
  TriangleSoup soup;
  constexpr int kPairs = 32;
  const double pitch = 0.8 / kPairs;
  const double thin = std::min(value.number, 0.5 * pitch);
  for (int i = 0; i < kPairs; ++i) {
    const double x0 = 0.85 + pitch * i;
    soup.add_sheet(x0, x0 + thin, 0.0, 0.8, 1.2);
    soup.add_sheet(x0 + thin, x0 + pitch, 0.0, 0.8, 1.2);
  }
  return with_soup(soup);
}

// A rug on the floor.
StressPoint coplanar_point(const StressValue& value) {
  TriangleSoup soup;
  soup.add_sheet(0.7, 2.0, -0.6, 1.4, value.number);
  return with_soup(soup);
}

StressPoint triangles_point(const StressValue& value) {
  constexpr int kMostSegments = 1024;  // of one sphere: a million triangles
  const double wanted = value.number;
  const int spheres = static_cast<int>(std::ceil(wanted / (double(kMostSegments) * (kMostSegments - 2))));
  const int segments = std::min(kMostSegments, 2 * static_cast<int>(std::sqrt(wanted / 4.0) + 1));
  StageScene stage = nominal_stage();
  stage.meshes = {stage_floor()};
  for (int i = 0; i < spheres; ++i) {
    stage.meshes.push_back(
        {fmt::format("name = \"sphere {}\"\nshape = \"sphere\"\nradius = 0.6\nsegments = {}\n", i, segments),
         {0.02 * i, 0.8, 0.01 * i}});
  }
  StressPoint point = point_of(stage);
  point.must_be_refused = wanted > 16777215.0;
  return point;
}

}  // namespace

std::vector<StressAxis> geometry_axes() {
  return {
      {.name = "wall_thickness",
       .unit = "world",
       .doc = "A wall 4 long and 2 high between the light and the camera.",
       .values = numbers({1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}),
       .needs_parameter = {},
       .point = wall_point},
      {.name = "contact_gap",
       .unit = "world",
       .doc = "Air between a box and the floor.",
       .values = numbers({1, 0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-6, 0}),
       .needs_parameter = {},
       .point = gap_point},
      {.name = "wire_radius",
       .unit = "world",
       .doc = "Three wires half a unit above the floor: a pixel is 0.03 to 0.1 wide, a texel about 0.02.",
       .values = numbers({0.2, 0.1, 0.03, 1e-2, 3e-3, 1e-3, 1e-4, 1e-6}),
       .needs_parameter = {},
       .point = wire_point},
      {.name = "sliver_width",
       .unit = "world",
       .doc = "A sheet of strips 0.8 long, every second one this wide.",
       .values = numbers({1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}),
       .needs_parameter = {},
       .point = sliver_point},
      {.name = "coplanar_gap",
       .unit = "world",
       .doc = "A sheet this far above the floor, and in it.",
       .values = numbers({1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 0}),
       .needs_parameter = {},
       .point = coplanar_point},
      {.name = "triangles",
       .unit = "triangles",
       .doc = "Spheres of up to a million triangles each, nearly in the same place.",
       .values = numbers({1e2, 1e3, 1e4, 1e5, 1e6, 8e6, 1.7e7}),
       .nominal = 2,
       .needs_parameter = {},
       .point = triangles_point},
  };
}

}  // namespace umbrameter

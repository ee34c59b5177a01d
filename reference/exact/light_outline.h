// SPDX-License-Identifier: Apache-2.0
#pragma once
// A light as a flat polygon for one receiver; a round one between two polygons.

#include "reference/exact/exact_visibility.h"
#include "scenes/light.h"

namespace umbrameter {

/// Inside the light lies `polygon`, around it `outer`; the same for a rectangle.
struct LightOutline {
  PolygonLight polygon;
  std::vector<glm::dvec2> outer;
  double area = 0.0;  // of the light itself, in the unit of the corners
  bool is_one_sided = false;
  bool is_flat = false;  // the polygon is where the light is: its solid angle weighs as the light does
};

/// The shape over which geometric visibility averages (scenes/light.h). Round lights get 512 corners: the two polygons
/// differ by 8e-5 of their area. The sun's disk is put `beyond_world` away. A receiver inside a sphere has none: no corners.
LightOutline outline_of(const Light& light, const glm::dvec3& p_world, double beyond_world);

}  // namespace umbrameter

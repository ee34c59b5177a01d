// SPDX-License-Identifier: Apache-2.0
#pragma once
// The exact visibility of any light in a scene of any size: only the triangles between the receiver and the light are
// looked at, and of these only the edges that bound their common shadow.

#include "reference/exact/triangle_tree.h"

#include <optional>

namespace umbrameter {

/// A point of a surface; the normals face the side it is seen from.
struct ExactReceiver {
  glm::dvec3 p_world{0.0};
  glm::dvec3 n_geometric_world{0.0};
  glm::dvec3 n_shading_world{0.0};
};

struct ExactLight {
  /// Geometric visibility (docs/conventions.md) lies between these: equal but for rounding under a rectangle, at most 8e-5
  /// apart under round lights.
  double visibility_low = 0.0;
  double visibility_high = 0.0;
  /// Of the visible part of the light, over that of all of it; the closed form for polygons (Lambert). Rectangle and disk.
  std::optional<double> irradiance_ratio;
  size_t triangles = 0;  // between the receiver and the light
  size_t edges = 0;      // that bound their shadow
  double visibility() const { return 0.5 * (visibility_low + visibility_high); }
};

/// Corners, receiver and light are taken at their exact double values, and which region of the light is seen is decided in
/// exact arithmetic; areas are then added up in double precision, to about 1e-12. Surfaces within a millionth of the way
/// from the light's plane hide nothing (a lamp's own panel). Duplicate, touching, overlapping and edge-on triangles and those
/// that cross the planes of light or receiver are all part of the answer.
ExactLight exact_light(const TriangleTree& tree, const ExactReceiver& receiver, const Light& light);

}  // namespace umbrameter

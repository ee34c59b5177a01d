// SPDX-License-Identifier: Apache-2.0
#pragma once
// The receiver a frame shows, read from its position, normal and primitive_id channels.

#include "core/image.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace umbrameter {

/// Views into an image that must outlive it. Pixels are indices y * width + x.
struct SurfaceView {
  int width = 0, height = 0;
  std::array<std::span<const float>, 3> position, normal;
  std::span<const float> primitive;

  bool hit(size_t i) const { return primitive[i] >= 0.0f; }
  glm::dvec3 p_world(size_t i) const { return {position[0][i], position[1][i], position[2][i]}; }
  glm::dvec3 n_world(size_t i) const { return {normal[0][i], normal[1][i], normal[2][i]}; }
};

/// Error{input} when a channel is missing, primitive_id is not a number of -1 or more, or position or normal
/// of a hit pixel is not finite.
SurfaceView checked_surface(const Image& image);

/// Whether two pixels see one smooth surface: the same primitive, or each point within `kSurfaceBend` of the
/// other's tangent plane, as on a tessellated curved surface but not across a crease, a step or a silhouette.
bool same_surface(const SurfaceView& surface, size_t i, size_t j);

/// How far pixel `i` reaches over its surface: to its neighbour on the left or above, whichever is further; 0 where
/// neither is of its surface.
double pixel_extent_world(const SurfaceView& surface, size_t i);

/// Sine of the angle two neighbouring facets of one surface may differ by (20 degrees).
inline constexpr double kSurfaceBend = 0.342;

}  // namespace umbrameter

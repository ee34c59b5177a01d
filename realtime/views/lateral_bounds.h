// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bounds of boxes as a light sees them. Internal to views/.

#include "realtime/views/light_view.h"

#include <glm/vec2.hpp>

#include <limits>
#include <span>

namespace umbrameter {

inline constexpr double kTanLimit = 5.671281819617709;  // tan(80 deg)

/// Lateral extent (tan space or world units) and range of distances.
struct LateralBounds {
  glm::dvec2 min{std::numeric_limits<double>::infinity()};
  glm::dvec2 max{-std::numeric_limits<double>::infinity()};
  double near = std::numeric_limits<double>::infinity();
  double far = -std::numeric_limits<double>::infinity();
  bool empty() const { return min.x > max.x; }
};

/// Of the parts of the boxes in front of the light, |tan| limited to kTanLimit; empty when nothing is in
/// front.
LateralBounds bound_perspective(const glm::dmat4& light_from_world, std::span<const ReceiverTile> tiles);

/// Of whole boxes, in world units.
LateralBounds bound_orthographic(const glm::dmat4& light_from_world, std::span<const ReceiverTile> tiles);

}  // namespace umbrameter

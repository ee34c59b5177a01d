// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/lateral_bounds.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

/// Distance at which boxes that reach behind the light are cut, relative to the farthest corner.
constexpr double kCutShare = 1e-6;

using Corners = std::array<glm::dvec3, 8>;

Corners corners_in_light(const glm::dmat4& light_from_world, const ReceiverTile& tile) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 p_world((i & 1) != 0 ? tile.max_world.x : tile.min_world.x,
                             (i & 2) != 0 ? tile.max_world.y : tile.min_world.y,
                             (i & 4) != 0 ? tile.max_world.z : tile.min_world.z, 1.0);
    corners[static_cast<size_t>(i)] = glm::dvec3(light_from_world * p_world);
  }
  return corners;
}

void include(LateralBounds& bounds, const glm::dvec2& lateral, double distance) {
  bounds.min = glm::min(bounds.min, lateral);
  bounds.max = glm::max(bounds.max, lateral);
  bounds.near = std::min(bounds.near, distance);
  bounds.far = std::max(bounds.far, distance);
}

void include_perspective(LateralBounds& bounds, const glm::dvec3& p_light) {
  const glm::dvec2 lateral = glm::dvec2(p_light) / p_light.z;
  include(bounds, glm::clamp(lateral, -kTanLimit, kTanLimit), p_light.z);
}

/// Along an edge x/z and y/z are monotone, so the ends of its part beyond `cut` bound it.
void include_edge(LateralBounds& bounds, const glm::dvec3& a, const glm::dvec3& b, double cut) {
  if (a.z < cut && b.z < cut) return;
  for (const glm::dvec3& p : {a, b}) {
    if (p.z >= cut) include_perspective(bounds, p);
  }
  if ((a.z < cut) == (b.z < cut)) return;
  glm::dvec3 crossing = glm::mix(a, b, (cut - a.z) / (b.z - a.z));
  crossing.z = cut;
  include_perspective(bounds, crossing);
}

}  // namespace

LateralBounds bound_perspective(const glm::dmat4& light_from_world, std::span<const ReceiverTile> tiles) {
  LateralBounds bounds;
  for (const ReceiverTile& tile : tiles) {
    const Corners corners = corners_in_light(light_from_world, tile);
    double farthest = 0.0;
    for (const glm::dvec3& p : corners) farthest = std::max(farthest, p.z);
    if (farthest <= 0.0) continue;
    for (size_t i = 0; i < 8; ++i) {
      for (const size_t axis : {1u, 2u, 4u}) {
        if ((i & axis) == 0) include_edge(bounds, corners[i], corners[i | axis], kCutShare * farthest);
      }
    }
  }
  return bounds;
}

LateralBounds bound_orthographic(const glm::dmat4& light_from_world, std::span<const ReceiverTile> tiles) {
  LateralBounds bounds;
  for (const ReceiverTile& tile : tiles) {
    for (const glm::dvec3& p : corners_in_light(light_from_world, tile)) include(bounds, glm::dvec2(p), p.z);
  }
  return bounds;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/clip_planes.h"

#include <cmath>

namespace umbrameter {
namespace {

/// Of the sum of a plane's absolute terms: far above the rounding of GL's floats, far below a texel of a useful map.
constexpr double kSlack = 1e-4;

}  // namespace

ClipPlanes clip_planes(const glm::dmat4& clip_from_world, bool clamps_depth) {
  const glm::dmat4 rows = glm::transpose(clip_from_world);
  const glm::dvec4 x = rows[0], y = rows[1], z = rows[2], w = rows[3];
  ClipPlanes planes{w, w + x, w - x, w + y, w - y};
  if (!clamps_depth) planes.insert(planes.end(), {z, w - z});
  return planes;
}

bool is_behind(const glm::dvec4& plane, const glm::vec3& min_world, const glm::vec3& max_world) {
  double value = plane.w;
  double scale = std::abs(plane.w);
  for (int axis = 0; axis < 3; ++axis) {
    const double farthest = plane[axis] > 0.0 ? max_world[axis] : min_world[axis];
    value += plane[axis] * farthest;
    scale += std::abs(plane[axis] * farthest);
  }
  return value < -kSlack * scale;
}

}  // namespace umbrameter

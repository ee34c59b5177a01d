// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/casters.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <limits>

namespace umbrameter {
namespace {

/// Of the sum of a plane's absolute terms: far above the rounding of GL's floats, far below a texel of a useful map.
constexpr double kSlack = 1e-4;

/// Nothing with dot(plane, (p_world, 1)) < 0 at all its points is drawn.
using ClipPlanes = std::vector<glm::dvec4>;

/// w >= 0, -w <= x <= w, -w <= y <= w, and with clipped depth 0 <= z <= w.
ClipPlanes clip_planes(const LightView& view, bool clamps_depth) {
  const glm::dmat4 rows =
      glm::transpose(glm::dmat4(view.clip_from_light) * glm::dmat4(view.light_from_world));
  const glm::dvec4 x = rows[0], y = rows[1], z = rows[2], w = rows[3];
  ClipPlanes planes{w, w + x, w - x, w + y, w - y};
  if (!clamps_depth) planes.insert(planes.end(), {z, w - z});
  return planes;
}

/// Whether the corner that lies farthest along the plane is still behind it.
bool is_behind(const glm::dvec4& plane, const CasterCluster& cluster) {
  double value = plane.w;
  double scale = std::abs(plane.w);
  for (int axis = 0; axis < 3; ++axis) {
    const double farthest = plane[axis] > 0.0 ? cluster.max_world[axis] : cluster.min_world[axis];
    value += plane[axis] * farthest;
    scale += std::abs(plane[axis] * farthest);
  }
  return value < -kSlack * scale;
}

uint32_t end_of(const std::vector<TriangleRange>& ranges) {
  return ranges.empty() ? 0 : ranges.back().first + ranges.back().count;
}

}  // namespace

std::vector<CasterCluster> make_caster_clusters(const Scene& scene) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::vector<CasterCluster> clusters;
  const auto total = static_cast<uint32_t>(scene.triangles.size());
  for (uint32_t first = 0; first < total; first += kClusterTriangles) {
    const uint32_t count = std::min(kClusterTriangles, total - first);
    CasterCluster cluster{{first, count}, glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    for (uint32_t i = first; i < first + count; ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const glm::vec3& p_world = scene.positions_world[scene.triangles[i][corner]];
        cluster.min_world = glm::min(cluster.min_world, p_world);
        cluster.max_world = glm::max(cluster.max_world, p_world);
      }
    }
    clusters.push_back(cluster);
  }
  return clusters;
}

std::vector<TriangleRange> casters_in_view(std::span<const CasterCluster> clusters, const LightView& view,
                                           bool clamps_depth) {
  const ClipPlanes planes = clip_planes(view, clamps_depth);
  std::vector<TriangleRange> ranges;
  for (const CasterCluster& cluster : clusters) {
    if (std::ranges::any_of(planes, [&](const glm::dvec4& plane) { return is_behind(plane, cluster); }))
      continue;
    const TriangleRange& triangles = cluster.triangles;
    if (triangles.first - end_of(ranges) >= kLeastGap) ranges.push_back({triangles.first, 0});
    if (ranges.empty()) ranges.push_back({0, 0});
    ranges.back().count = triangles.first + triangles.count - ranges.back().first;
  }
  const auto total = clusters.empty() ? 0 : clusters.back().triangles.first + clusters.back().triangles.count;
  if (!ranges.empty() && total - end_of(ranges) < kLeastGap)
    ranges.back().count = total - ranges.back().first;
  return ranges;
}

}  // namespace umbrameter

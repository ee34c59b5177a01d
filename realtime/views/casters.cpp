// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/casters.h"

#include "realtime/views/clip_planes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>

namespace umbrameter {
namespace {

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
  const ClipPlanes planes =
      clip_planes(glm::dmat4(view.clip_from_light) * glm::dmat4(view.light_from_world), clamps_depth);
  std::vector<TriangleRange> ranges;
  for (const CasterCluster& cluster : clusters) {
    if (is_clipped(planes, cluster.min_world, cluster.max_world)) continue;
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

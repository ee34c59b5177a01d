// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which triangles can reach a light's map at all: what lies beside it, behind the light or beyond its farthest receiver
// is clipped by GL anyway, after its vertices were fetched and transformed. No GL.

#include "realtime/views/light_view.h"

#include <cstdint>
#include <vector>

namespace umbrameter {

/// Consecutive triangles of a scene.
struct TriangleRange {
  uint32_t first = 0;
  uint32_t count = 0;
};

/// Triangles next to each other in the scene's order, and the box around them.
struct CasterCluster {
  TriangleRange triangles;
  glm::vec3 min_world;
  glm::vec3 max_world;
};

/// Every triangle of the scene, in order, kClusterTriangles at a time.
std::vector<CasterCluster> make_caster_clusters(const Scene& scene);
inline constexpr uint32_t kClusterTriangles = 256;

/// Ranges in the scene's order, kLeastGap apart, that hold every triangle of which GL may draw a part through `view`.
/// `clamps_depth`: nothing is clipped by distance (GL_DEPTH_CLAMP).
std::vector<TriangleRange> casters_in_view(std::span<const CasterCluster> clusters, const LightView& view,
                                           bool clamps_depth);
/// Triangles: one more range to draw costs more than the vertices of a shorter gap (llvmpipe: about 2 ms a range).
inline constexpr uint32_t kLeastGap = 4096;

}  // namespace umbrameter

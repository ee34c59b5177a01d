// SPDX-License-Identifier: Apache-2.0
#include "realtime/graph/scene_read.h"

#include <algorithm>
#include <array>

namespace umbrameter {

std::span<const SceneReadInfo> scene_reads() {
  // Bindings 0 to 2 as in realtime/harness/scene_buffers.h; 3 and 4 are cut-outs' and instances'.
  static constexpr std::array<SceneReadInfo, 5> kReads = {{
      {SceneRead::positions, "scene.positions", 0,
       "layout(std430, binding = 0) readonly buffer ScenePositions { float scene_positions[]; };\n"},
      {SceneRead::triangles, "scene.triangles", 1,
       "layout(std430, binding = 1) readonly buffer SceneTriangles { uint scene_triangles[]; };\n"},
      {SceneRead::normals, "scene.normals", 2,
       "layout(std430, binding = 2) readonly buffer SceneNormals { float scene_normals[]; };\n"},
      {SceneRead::adjacency, "scene.adjacency", 5,
       "layout(std430, binding = 5) readonly buffer SceneAdjacency { uint scene_adjacency[]; };\n"},
      {SceneRead::bvh, "scene.bvh", 6,
       "layout(std430, binding = 6) readonly buffer SceneBvh { uvec4 scene_bvh[]; };\n"},
  }};
  return kReads;
}

const SceneReadInfo* find_scene_read(std::string_view name) {
  const auto reads = scene_reads();
  const auto found = std::ranges::find(reads, name, &SceneReadInfo::name);
  return found == reads.end() ? nullptr : &*found;
}

}  // namespace umbrameter

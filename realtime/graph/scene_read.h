// SPDX-License-Identifier: Apache-2.0
#pragma once
// Data of the scene that passes may name in `reads`: storage buffers, made on demand.

#include <span>
#include <string_view>

namespace umbrameter {

enum class SceneRead {
  positions,  // of vertices
  triangles,  // the vertices of each
  normals,    // of vertices, unit
  adjacency,  // the triangle across each edge of each triangle
  bvh         // boxes around triangles, in a tree
};

struct SceneReadInfo {
  SceneRead read;
  std::string_view name;   // as manifests call it
  unsigned binding;        // of storage buffers
  std::string_view block;  // how GLSL declares it
};

/// In the order of the enumeration.
std::span<const SceneReadInfo> scene_reads();
/// Null for other names.
const SceneReadInfo* find_scene_read(std::string_view name);

}  // namespace umbrameter

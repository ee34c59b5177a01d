// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles on their way from a file's nodes to one mesh.

#include "scenes/mesh_data.h"
#include "scenes/mesh_filter.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace umbrameter {

/// Of one material, at one node.
struct Primitive {
  struct Vertex {
    glm::dvec3 p{0.0};
    glm::dvec3 n{0.0};  // zero: none that can be used
    glm::vec2 uv{0.0f};
  };

  std::string label;  // of the part it goes to
  std::vector<Vertex> vertices;
  std::vector<glm::uvec3> triangles;
  bool has_normals = false;
  std::optional<uint32_t> mask;  // in the mesh's masks
};

/// Moves position and normal.
void place(Primitive::Vertex& vertex, const glm::dmat4& world_from_node);

/// Moves positions and normals, and turns triangles where `world_from_node` mirrors: outside stays outside.
void place(Primitive& primitive, const glm::dmat4& world_from_node);

/// Primitives of one label become one part, in order of appearance. Triangles without usable normals become flat.
MeshData assemble_mesh(const std::vector<Primitive>& primitives, std::vector<AlphaMask> masks);

/// Drops the masks that no cutout names.
void keep_used_masks(MeshData& mesh);

/// A filter by the names of materials, meshes and nodes, which remembers the names it saw.
class NameFilter {
 public:
  explicit NameFilter(const MeshFilter& filter) : filter_(filter) {}

  bool keeps(const std::set<std::string>& names);
  /// Error{input} for a name that was never seen.
  void require_all_seen(const std::filesystem::path& file) const;

 private:
  const MeshFilter& filter_;
  std::set<std::string> seen_;
};

}  // namespace umbrameter

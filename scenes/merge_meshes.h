// SPDX-License-Identifier: Apache-2.0
#pragma once
// Puts the meshes of a scene file into the scene's one triangle list, and those that are kept once beside it.

#include "scenes/mesh_data.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A mesh in world space, ready to be merged.
struct NamedMesh {
  std::string name;   // of the [[mesh]]
  std::string label;  // for warnings: the file's name, or the mesh's name
  FileLocation where;
  MeshData mesh;
  std::optional<AnimatedMesh> animated = {};
};

/// Fills positions, normals, triangles, parts and bounds of `scene` from `meshes` (which are emptied), in
/// order. Drops triangles whose area in floats is zero and all but the first of triangles with the same three
/// positions; each mesh that lost some gets a line in scene.warnings. If any mesh has shading normals, the
/// others get their geometric normals, each triangle its own three vertices. Parts are called "mesh" or
/// "mesh/material". Repeated meshes become scene.instanced: a mirrored instance shows the mirror image, a mesh of its own,
/// and of instances in one place all but the first are dropped, with a line in scene.warnings. Error{input} for coordinates
/// that are not finite or too large, more than kMaxTriangles triangles or kMaxShownTriangles shown ones, and a mesh whose
/// triangles all have no area.
void merge_meshes(std::vector<NamedMesh>& meshes, Scene& scene);

/// Gives each triangle its own vertices, with the triangle's normal.
void split_flat(MeshData& mesh);

/// merge_meshes()' part for the repeated ones of `owner`: they get normals where `is_smooth`. Bounds grow with them.
void add_instances(NamedMesh& owner, bool is_smooth, Scene& scene);

}  // namespace umbrameter

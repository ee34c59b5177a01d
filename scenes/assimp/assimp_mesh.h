// SPDX-License-Identifier: Apache-2.0
#pragma once
// Mesh files of other formats through assimp: FBX, Collada, PLY, STL.

#include "scenes/mesh_data.h"
#include "scenes/mesh_filter.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// True for names that end in one of assimp_endings().
bool is_read_by_assimp(const std::string& name);

/// All nodes' meshes as one, in the file's world; FBX and Collada in metres. Parts are materials (else meshes); `filter`
/// goes by the names of materials, meshes and nodes. A material's opacity picture beside the file makes holes. What is left
/// out (points, lines, bones, animations, cameras, lights, masks that are not there) is said in `warnings`. Error{input} for
/// files that assimp cannot read, values that are not finite, no triangles, and a filter name that is not in the file.
MeshData load_assimp_mesh(const std::filesystem::path& path, const MeshFilter& filter,
                          std::vector<std::string>& warnings);

}  // namespace umbrameter

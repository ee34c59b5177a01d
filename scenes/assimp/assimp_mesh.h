// SPDX-License-Identifier: Apache-2.0
#pragma once
// Mesh files of other formats through assimp: FBX, Collada, PLY, STL.

#include "scenes/assimp/assimp_file.h"
#include "scenes/mesh_data.h"
#include "scenes/mesh_filter.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// True for names that end in one of assimp_endings().
bool is_read_by_assimp(const std::string& name);

/// All nodes' meshes as one, in the file's world; FBX and Collada in metres. Parts are materials (else meshes); `filter`
/// goes by the names of materials, meshes and nodes. Bones bend meshes as their nodes stand; vertices without bones stay with their
/// node, and weights of another sum than 1 are scaled to it, as FBX says. Morph targets count where an animation gives them weights. A
/// material's opacity picture beside the file makes holes. What is left out (points, lines, morph targets without weights, Collada's
/// cameras and lights, masks that are not there), scaled weights and file.warnings are said in `warnings`. Error{input} for values
/// that are not finite, bones that are no nodes, no triangles, and a filter name that is not in the file.
MeshData load_assimp_mesh(const AssimpFile& file, const MeshFilter& filter,
                          std::vector<std::string>& warnings);

/// The same of a file at a moment of its animation.
MeshData load_assimp_mesh(const std::filesystem::path& path, const MeshFilter& filter,
                          const std::optional<AnimationTime>& at, std::vector<std::string>& warnings);

}  // namespace umbrameter

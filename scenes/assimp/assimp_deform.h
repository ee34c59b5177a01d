// SPDX-License-Identifier: Apache-2.0
#pragma once
// What bends a mesh of assimp's: morph targets and bones.

#include "scenes/assimp/assimp_file.h"
#include "scenes/skin.h"

struct aiMesh;

namespace umbrameter {

/// Vertices that are not as FBX wants them.
struct AssimpBoneCounts {
  size_t boneless = 0;  // moved by no bone: they stay with their node
  size_t scaled = 0;    // whose weights summed to something else than 1
};

/// Moves positions and normals towards the targets of `mesh` by the weights that the animation gives `node`; false where it gives
/// none. Error{input} for targets of another number of vertices, and for what is not finite.
bool apply_assimp_morphs(const AssimpFile& file, const aiMesh& mesh, const std::string& node,
                         Primitive& primitive);

/// Error{input} for bones that are no nodes, vertices that are not there, and weights that are negative or not finite.
Skinning read_assimp_bones(const AssimpFile& file, const aiMesh& mesh, const glm::dmat4& world_from_node,
                           AssimpBoneCounts& counts);

}  // namespace umbrameter

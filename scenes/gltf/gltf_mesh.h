// SPDX-License-Identifier: Apache-2.0
#pragma once
// All meshes of a glTF file as one, in the file's world: metres, y up.

#include "scenes/gltf/gltf_model.h"
#include "scenes/mesh_data.h"
#include "scenes/mesh_filter.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Every triangle primitive of every node. Parts are materials (else meshes), in order of appearance; `filter` goes by the
/// names of materials, meshes and nodes. Normals become shading normals; triangles without usable ones keep their own.
/// A mesh that several nodes show becomes a repeated one where is_kept_once() says so.
/// Morph targets and skins bend it as the nodes stand. alphaMode MASK, and BLEND as if its cutoff were 0.5, make holes by the base
/// colour's alpha. What is left out (lines, points) and file.warnings are said in `warnings`. Error{input} for indices of vertices that are not
/// there, no triangles, and a filter name that is not in the file.
MeshData load_gltf_mesh(const GltfFile& file, const MeshFilter& filter, std::vector<std::string>& warnings);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Mesh files that scene files of other renderers name.

#include "scenes/mesh_data.h"
#include "scenes/mesh_filter.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// An OBJ or a PLY file, without its own materials. Error{input} as load_obj() and load_assimp_mesh().
MeshData load_mesh_of_file(const std::filesystem::path& file, MeshMasks masks,
                           std::vector<std::string>& warnings);

}  // namespace umbrameter

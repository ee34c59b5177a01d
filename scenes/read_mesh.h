// SPDX-License-Identifier: Apache-2.0
#pragma once
// [[mesh]] of a scene file: a shape or an OBJ file, and its transform.

#include "core/toml.h"
#include "scenes/load_scene.h"
#include "scenes/merge_meshes.h"

#include <filesystem>
#include <optional>

namespace umbrameter {

/// Reads one `table` (docs/scene-format.md) and brings it to world space. `folder` is the scene file's.
NamedMesh read_mesh(const TomlNode& table, const std::filesystem::path& folder, const SceneSearch& search,
                    std::vector<std::string>& warnings);

/// The mesh file called `name`: beside the scene, then in search.assets; empty when it is in neither.
std::optional<std::filesystem::path> find_mesh_file(const std::string& name,
                                                    const std::filesystem::path& folder,
                                                    const SceneSearch& search);

}  // namespace umbrameter

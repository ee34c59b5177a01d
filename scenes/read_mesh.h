// SPDX-License-Identifier: Apache-2.0
#pragma once
// [[mesh]] tables of a scene file: a shape or a file, and its transform.

#include "core/toml.h"
#include "scenes/load_scene.h"
#include "scenes/merge_meshes.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Reads `[[mesh]]` tables (docs/scene-format.md) and brings them to world space. `folder` is the scene file's. Tables that
/// name one file, with one filter and at one moment, become one repeated mesh with the first table's name where is_kept_once() says so.
std::vector<NamedMesh> read_meshes(std::span<const TomlNode* const> tables,
                                   const std::filesystem::path& folder, const SceneSearch& search,
                                   std::vector<std::string>& warnings);

/// The mesh file called `name`: beside the scene, then in search.assets; empty when it is in neither.
std::optional<std::filesystem::path> find_mesh_file(const std::string& name,
                                                    const std::filesystem::path& folder,
                                                    const SceneSearch& search);

}  // namespace umbrameter

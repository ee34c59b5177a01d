// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which files a scene comes from, without reading the large ones.

#include "scenes/load_scene.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace umbrameter {

/// The mesh files that the scene file names, in order; absent when one is not there, or the scene file says something else
/// that load_scene() will complain of.
std::optional<std::vector<std::filesystem::path>> mesh_files(const std::filesystem::path& file,
                                                             const SceneSearch& search);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes that are not loaded as long as only their description is needed: it is remembered in a store.

#include "lab/scene_jobs.h"
#include "store/lazy_store.h"

#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Descriptions of the scene's views, one a light, from the store or from loading it. What is loaded is kept until it has
/// been used.
std::vector<SceneSource> open_scene(LazyStore& store, const std::string& name_or_path,
                                    const SceneSearch& search);

/// Keeps the descriptions of a loaded scene's views under the text of its file and the sizes and times of its meshes.
void keep_scene(LazyStore& store, const std::string& name_or_path, const SceneSearch& search,
                std::span<const SceneSource> sources);

}  // namespace umbrameter

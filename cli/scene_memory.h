// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes that are not loaded as long as only their description is needed: it is remembered in a store.

#include "cli/home.h"
#include "study/store/late_store.h"

#include <string>
#include <vector>

namespace umbrameter {

/// The scene's description from the store, or from loading it. What is loaded is kept until it has been used.
SceneSource open_scene(LateStore& store, const std::string& name_or_path, const SceneSearch& search);

/// Keeps the description of a loaded scene under the text of its file and the sizes and times of its meshes.
void remember_scene(LateStore& store, const std::string& name_or_path, const SceneSearch& search,
                    const SceneSource& source);

}  // namespace umbrameter

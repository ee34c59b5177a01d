// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where tests find the real models, which are no part of the project.

#include "scenes/load_scene.h"

#include <string>

namespace umbrameter {

/// The library's scenes, and the models in UMBRAMETER_ASSETS or else beside the source tree, in shared/models.
SceneSearch model_search();

bool has_models();

/// Why a test is skipped without them.
std::string no_models();

}  // namespace umbrameter

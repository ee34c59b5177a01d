// SPDX-License-Identifier: Apache-2.0
#pragma once
// The views of a scene file, one a light, under the names that results call them by.

#include "lab/validation.h"
#include "scenes/load_scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// The library name, or the stem, of a scene file.
std::string scene_name(const std::filesystem::path& file, const SceneSearch& search);

/// A scene of the library by name, or a scene file, once for each of its lights or for `search.light` alone: under its
/// scene_name(), with `search.at` its timed_name(), or "scene/light" when the file has several. Error{input} for a light that is
/// not there.
std::vector<SceneJob> load_scene_jobs(const std::string& name_or_path, const SceneSearch& search);

/// The same where one light is wanted: Error{input} when the scene has several and none is chosen.
SceneJob load_scene_job(const std::string& name_or_path, const SceneSearch& search);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is in the window as files that every verb reads: scene, preset, study.

#include "core/parameters.h"
#include "scenes/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace umbrameter {

/// The text of the scene's file with the camera and the one light given, and with `at` its animated meshes at that moment,
/// everything else as it stands. Mesh files beside the scene's file are named so that they are found from `target`'s folder.
/// Error{input} for a scene file that is no TOML.
std::string scene_toml(const Scene& scene, const std::optional<AnimationTime>& at,
                       const std::filesystem::path& target, const Camera& camera, const Light& light);

/// A preset file (docs/tuning.md) of every value that is not the default.
std::string view_preset_toml(const std::string& technique, std::span<const Parameter> parameters,
                             const ParameterValues& values);

/// A study (docs/studies.md) of the technique in the scene file `scene`.
std::string view_study_toml(const std::string& scene, const std::string& technique,
                            std::span<const Parameter> parameters, const ParameterValues& values,
                            int width_px, int height_px);

}  // namespace umbrameter

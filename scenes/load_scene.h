// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scene files: TOML -> Scene. The format is described in docs/scene-format.md.

#include "core/toml.h"
#include "scenes/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct SceneSearch {
  std::filesystem::path assets;   // --assets or UMBRAMETER_ASSETS; empty = none
  std::filesystem::path library;  // folder of the built-in scenes
  std::string light = {};         // name or number of the one that verbs look at; empty = every light
  std::optional<AnimationTime> at =
      {};  // of all meshes whose files have animations, instead of the scene file's
};

/// Loads a scene file, with all its lights; or another program's file as scenes/import_scene.h reads it. Meshes named by file are looked for beside the scene file, then in `search.assets`.
/// Error{input} with file, line, column and hint for every kind of bad input, and for `search.at` where nothing is animated.
Scene load_scene(const std::filesystem::path& file, const SceneSearch& search);

/// Parses a scene from text, as if it stood in `file`.
Scene parse_scene(std::string_view document, const std::filesystem::path& file, const SceneSearch& search);

/// One scene of the library, as listed.
struct SceneEntry {
  std::string name;  // "plate", "assets/bunny"
  std::string title;
  std::filesystem::path file;
  bool needs_assets = false;
  std::vector<std::string> missing_assets;  // mesh files that were not found
};

/// All scenes under `search.library`, built-in first, then assets/, each by name. Reads only the TOML, no
/// meshes.
std::vector<SceneEntry> list_scenes(const SceneSearch& search);

/// "plate" or "assets/bunny" -> its file in the library; an existing path -> itself; Error{input} with the
/// nearest scene name otherwise.
std::filesystem::path resolve_scene(const std::string& name_or_path, const SceneSearch& search);

}  // namespace umbrameter

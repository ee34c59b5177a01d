// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scenes that engines read, as folders with scene.obj and scene.json: written once, the last few kept.

#include "scenes/scene.h"

#include <filesystem>
#include <list>
#include <string>

namespace umbrameter {

class SceneFolders {
 public:
  /// Below `root`, which must exist.
  explicit SceneFolders(std::filesystem::path root) : root_(std::move(root)) {}

  /// Of the scene's camera and active light at this size.
  std::filesystem::path folder_of(const Scene& scene, int width_px, int height_px);

 private:
  std::filesystem::path mesh_of(const Scene& scene);

  std::filesystem::path root_;
  std::list<std::filesystem::path> folders_, meshes_;  // last used first
};

}  // namespace umbrameter

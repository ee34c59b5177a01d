// SPDX-License-Identifier: Apache-2.0
#include "tests/support/models.h"
#include "tests/support/source_dir.h"

#include <cstdlib>
#include <filesystem>

namespace umbrameter {

SceneSearch model_search() {
  const std::filesystem::path source = source_dir();
  const char* folder = std::getenv("UMBRAMETER_ASSETS");
  return {
      .assets = folder != nullptr ? std::filesystem::path(folder) : source.parent_path() / "shared/models",
      .library = source / "scenes/library"};
}

bool has_models() {
  return std::filesystem::is_directory(model_search().assets);
}

std::string no_models() {
  return "no models in '" + model_search().assets.string() + "'; set UMBRAMETER_ASSETS to their folder";
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_files.h"

#include "scenes/import_scene.h"
#include "scenes/read_mesh.h"

namespace umbrameter {

std::optional<std::vector<std::filesystem::path>> mesh_files(const std::filesystem::path& file,
                                                             const SceneSearch& search) {
  if (is_importable(file.string())) return std::vector{file};
  std::vector<std::filesystem::path> files;
  try {
    const TomlNode root = parse_toml_file(file);
    TomlReader reader(root, "the scene");
    for (const TomlNode* table : reader.tables("mesh")) {
      TomlReader mesh(*table, "[[mesh]]");
      if (!mesh.has("file")) continue;
      const auto found = find_mesh_file(mesh.text("file"), file.parent_path(), search);
      if (!found) return std::nullopt;
      files.push_back(*found);
    }
  } catch (const Error&) {
    return std::nullopt;
  }
  return files;
}

}  // namespace umbrameter

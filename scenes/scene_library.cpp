// SPDX-License-Identifier: Apache-2.0
// The listing and naming half of load_scene.h.

#include "core/names.h"
#include "scenes/load_scene.h"
#include "scenes/read_mesh.h"

#include <algorithm>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

/// The .toml files right inside `folder`, by name; none when it does not exist.
std::vector<fs::path> scene_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

SceneEntry read_entry(const std::string& name, const fs::path& file, const SceneSearch& search) {
  const TomlNode root = parse_toml_file(file);
  TomlReader reader(root, "the scene");
  SceneEntry entry{name, reader.text("title", name), file, false, {}};
  for (const TomlNode* table : reader.tables("mesh")) {
    TomlReader mesh(*table, "[[mesh]]");
    if (!mesh.has("file")) continue;
    const std::string mesh_file = mesh.text("file");
    const bool is_missing = !find_mesh_file(mesh_file, file.parent_path(), search);
    entry.needs_assets |= !fs::is_regular_file(file.parent_path() / mesh_file);
    if (is_missing) entry.missing_assets.push_back(mesh_file);
  }
  return entry;
}

/// Name and file of every scene of the library.
std::vector<std::pair<std::string, fs::path>> name_scenes(const SceneSearch& search) {
  std::vector<std::pair<std::string, fs::path>> scenes;
  for (const fs::path& file : scene_files(search.library)) scenes.emplace_back(file.stem().string(), file);
  for (const fs::path& file : scene_files(search.library / "assets")) {
    scenes.emplace_back("assets/" + file.stem().string(), file);
  }
  return scenes;
}

}  // namespace

std::vector<SceneEntry> list_scenes(const SceneSearch& search) {
  std::vector<SceneEntry> entries;
  for (const auto& [name, file] : name_scenes(search)) entries.push_back(read_entry(name, file, search));
  return entries;
}

std::filesystem::path resolve_scene(const std::string& name_or_path, const SceneSearch& search) {
  std::error_code ignored;
  if (fs::is_regular_file(name_or_path, ignored)) return name_or_path;
  std::vector<std::string> names;
  for (const auto& [name, file] : name_scenes(search)) {
    if (name == name_or_path) return file;
    names.push_back(name);
  }
  fail_input(fmt::format("no scene or scene file is called '{}'", name_or_path), {},
             suggest_name(name_or_path, names));
}

}  // namespace umbrameter

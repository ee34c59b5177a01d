// SPDX-License-Identifier: Apache-2.0
// The listing and naming half of load_scene.h.

#include "core/file_hint.h"
#include "core/names.h"
#include "scenes/file_ending.h"
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

bool looks_like_file(const std::string& text) {
  return fs::path(text).has_extension();
}

/// A mesh has neither camera nor light; files of other programs may have both, and get what they lack (scenes/import_scene.h).
void refuse_mesh(const std::string& file) {
  for (const char* ending : {".obj", ".stl", ".ply", ".dae"}) {
    if (!has_ending(file, ending)) continue;
    fail_input("this is a mesh, not a scene", {file},
               fmt::format("write a scene file with a [camera], a [[light]] and [[mesh]] file = \"{}\" "
                           "(docs/scene-format.md)",
                           fs::path(file).filename().string()));
  }
}

}  // namespace

std::vector<SceneEntry> list_scenes(const SceneSearch& search) {
  std::vector<SceneEntry> entries;
  for (const auto& [name, file] : name_scenes(search)) entries.push_back(read_entry(name, file, search));
  return entries;
}

std::filesystem::path resolve_scene(const std::string& name_or_path, const SceneSearch& search) {
  std::error_code ignored;
  if (fs::is_regular_file(name_or_path, ignored)) {
    refuse_mesh(name_or_path);
    return name_or_path;
  }
  std::vector<std::string> names;
  for (const auto& [name, file] : name_scenes(search)) {
    if (name == name_or_path) return file;
    names.push_back(name);
  }
  fail_input(
      fmt::format("no scene or scene file is called '{}'", name_or_path), {},
      looks_like_file(name_or_path) ? hint_for_missing(name_or_path) : suggest_name(name_or_path, names));
}

}  // namespace umbrameter

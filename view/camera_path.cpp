// SPDX-License-Identifier: Apache-2.0
#include "view/camera_path.h"

#include "core/toml.h"
#include "core/toml_text.h"
#include "scenes/read_camera.h"
#include "scenes/scene_text.h"
#include "view/camera_control.h"

#include <algorithm>

namespace umbrameter {
namespace {

CameraKey read_key(const TomlNode& table, double near_world) {
  TomlReader reader(table, "[[camera]]");
  CameraKey key;
  key.time_s = reader.number("time_s");
  TomlNode place = table;
  std::erase_if(place.entries, [](const TomlEntry& entry) { return entry.name == "time_s"; });
  key.camera = read_camera(place);
  if (key.camera.near_world == 0.0) key.camera.near_world = near_world;
  return key;
}

}  // namespace

Camera camera_at(const std::vector<CameraKey>& path, double time_s) {
  const auto later = std::ranges::lower_bound(path, time_s, {}, &CameraKey::time_s);
  if (later == path.begin()) return path.front().camera;
  if (later == path.end()) return path.back().camera;
  const CameraKey& from = *std::prev(later);
  return between(from.camera, later->camera, (time_s - from.time_s) / (later->time_s - from.time_s));
}

std::string camera_path_toml(const std::vector<CameraKey>& path) {
  std::string text = "# A flight through a scene, recorded in the window of `umbrameter view`.\n";
  for (const CameraKey& key : path)
    text += fmt::format("\n[[camera]]\ntime_s = {}\n{}", toml_number(key.time_s), camera_keys(key.camera));
  return text;
}

std::vector<CameraKey> read_camera_path(const std::filesystem::path& file, double near_world) {
  const TomlNode root = parse_toml_file(file);
  TomlReader reader(root, "a camera path");
  std::vector<CameraKey> path;
  for (const TomlNode* table : reader.tables("camera")) {
    path.push_back(read_key(*table, near_world));
    if (path.size() < 2 || path.back().time_s > path[path.size() - 2].time_s) continue;
    fail_input(fmt::format("'time_s' = {} does not rise", path.back().time_s), table->where);
  }
  reader.finish();
  if (path.empty()) fail_input("a camera path has no [[camera]]", {file.string()});
  return path;
}

}  // namespace umbrameter

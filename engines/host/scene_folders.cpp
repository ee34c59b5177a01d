// SPDX-License-Identifier: Apache-2.0
#include "engines/host/scene_folders.h"

#include "core/files.h"
#include "core/hash.h"
#include "scenes/export_scene.h"

#include <algorithm>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr size_t kFolders = 64;  // a tuning goes round between 13 cameras
constexpr size_t kMeshes = 4;

/// Moves `path` to the front; what is used least is removed.
void use(std::list<fs::path>& paths, const fs::path& path, size_t most) {
  paths.remove(path);
  paths.push_front(path);
  if (paths.size() <= most) return;
  fs::remove_all(paths.back());
  paths.pop_back();
}

}  // namespace

fs::path SceneFolders::mesh_of(const Scene& scene) {
  const fs::path file = root_ / (mesh_hash(scene) + ".obj");
  if (std::ranges::find(meshes_, file) == meshes_.end()) write_file_atomically(file, scene_obj_text(scene));
  use(meshes_, file, kMeshes);
  return file;
}

fs::path SceneFolders::folder_of(const Scene& scene, int width_px, int height_px) {
  const std::string json = scene_json_text(scene, scene.name, width_px, height_px);
  const fs::path folder = root_ / hash_text(json);
  if (std::ranges::find(folders_, folder) == folders_.end()) {
    create_folder(folder);
    fs::create_hard_link(mesh_of(scene), folder / "scene.obj");
    write_file_atomically(folder / "scene.json", json);
  }
  use(folders_, folder, kFolders);
  return folder;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/import_scene.h"

#include "scenes/assimp/import_assimp.h"
#include "scenes/file_ending.h"
#include "scenes/foreign/foreign_scene.h"
#include "scenes/gltf/gltf_model.h"
#include "scenes/gltf/import_gltf.h"
#include "scenes/mitsuba/read_mitsuba.h"
#include "scenes/pbrt/read_pbrt.h"

namespace umbrameter {
namespace {

ForeignScene read_foreign(const std::filesystem::path& path) {
  return has_ending(path.string(), ".xml") ? read_mitsuba(path) : read_pbrt(path);
}

FoundScene find_scene(const std::filesystem::path& path, const std::optional<AnimationTime>& at) {
  if (is_gltf(path.string())) return find_gltf_scene(path, at);
  if (!is_foreign_scene(path.string())) return find_assimp_scene(path, at);
  if (at) fail_not_animated(path, at->time_s);
  return find_foreign_scene(read_foreign(path));
}

}  // namespace

bool is_importable(const std::string& name) {
  return is_gltf(name) || is_assimp_scene(name) || is_foreign_scene(name);
}

bool is_foreign_scene(const std::string& name) {
  return has_ending(name, ".xml") || has_ending(name, ".pbrt");
}

MeshData load_foreign_mesh(const std::filesystem::path& path, const MeshFilter& filter,
                           std::vector<std::string>& warnings) {
  return foreign_mesh(read_foreign(path), filter, warnings);
}

ImportedScene import_file(const std::filesystem::path& path, const std::optional<AnimationTime>& at,
                          const std::filesystem::path& mesh_file) {
  return write_scene(find_scene(path, at), mesh_file);
}

}  // namespace umbrameter

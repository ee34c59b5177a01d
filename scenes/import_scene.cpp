// SPDX-License-Identifier: Apache-2.0
#include "scenes/import_scene.h"

#include "scenes/assimp/import_assimp.h"
#include "scenes/gltf/gltf_model.h"
#include "scenes/gltf/import_gltf.h"

namespace umbrameter {

bool is_importable(const std::string& name) {
  return is_gltf(name) || is_assimp_scene(name);
}

ImportedScene import_file(const std::filesystem::path& path, const std::optional<AnimationTime>& at,
                          const std::filesystem::path& mesh_file) {
  FoundScene found = is_gltf(path.string()) ? find_gltf_scene(path, at) : find_assimp_scene(path, at);
  return write_scene(std::move(found), mesh_file);
}

}  // namespace umbrameter

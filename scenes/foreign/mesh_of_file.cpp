// SPDX-License-Identifier: Apache-2.0
#include "scenes/foreign/mesh_of_file.h"

#include "scenes/assimp/assimp_mesh.h"
#include "scenes/file_ending.h"
#include "scenes/obj/load_obj.h"

namespace umbrameter {

MeshData load_mesh_of_file(const std::filesystem::path& file, MeshMasks masks,
                           std::vector<std::string>& warnings) {
  const MeshFilter all{.include = {}, .exclude = {}, .masks = masks};
  if (has_ending(file.string(), ".ply")) return load_assimp_mesh(file, all, std::nullopt, warnings);
  return load_obj(file, all, warnings);
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/assimp_file.h"

#include "core/error.h"
#include "scenes/assimp/assimp_animation.h"
#include "scenes/assimp/assimp_values.h"
#include "scenes/assimp/check_ply.h"
#include "scenes/file_ending.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

constexpr int kDeepest = 1000;  // of nested nodes

[[noreturn]] void fail_file(const AssimpFile& file, const std::string& message) {
  fail_input(message, {file.path.string()});
}

void read(AssimpFile& file) {
  Assimp::Importer& importer = *file.importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // else identifiers
  unsigned int steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_ValidateDataStructure;
  if (has_ending(file.path.string(), ".fbx"))
    steps |= aiProcess_GlobalScale;  // centimetres, mostly, to metres
  file.scene = importer.ReadFile(file.path.string(), steps);
  if (file.scene == nullptr || file.scene->mRootNode == nullptr)
    fail_file(file, fmt::format("the file cannot be read: {}", importer.GetErrorString()));
}

/// One of x, y, z with its sign, as FBX's global settings have it.
std::optional<glm::dvec3> axis_of(const aiScene& scene, const std::string& name) {
  int axis = 0, sign = 0;
  if (scene.mMetaData == nullptr || !scene.mMetaData->Get(name, axis) ||
      !scene.mMetaData->Get(name + "Sign", sign) || axis < 0 || axis > 2 || (sign != 1 && sign != -1))
    return std::nullopt;
  glm::dvec3 direction(0.0);
  direction[axis] = sign;
  return direction;
}

/// assimp leaves FBX's axes as they are.
glm::dmat4 world_from_root(const aiScene& scene) {
  const auto up = axis_of(scene, "UpAxis"), right = axis_of(scene, "CoordAxis");
  if (!up || !right || glm::dot(*up, *right) != 0.0) return glm::dmat4(1.0);
  return glm::dmat4(glm::transpose(glm::dmat3(*right, *up, glm::cross(*right, *up))));
}

void walk(AssimpFile& file, const AssimpPoses& poses, const aiNode& node, const AssimpNode& parent,
          int depth) {
  if (depth > kDeepest) fail_file(file, fmt::format("nodes are nested deeper than {}", kDeepest));
  const auto pose = poses.find(node.mName.C_Str());
  const bool is_posed = pose != poses.end();
  const glm::dmat4 world_from_node =
      parent.world_from_node * (is_posed ? pose->second : matrix_of(node.mTransformation));
  for (int column = 0; column < 4; ++column) {
    const glm::dvec4 values = world_from_node[column];
    if (!(std::abs(values.x) + std::abs(values.y) + std::abs(values.z) < 1e30))
      fail_file(file, fmt::format("the transform of node '{}' is not finite", node.mName.C_Str()));
  }
  const AssimpNode placed{&node, world_from_node, parent.is_moved || is_posed};
  file.nodes.push_back(placed);
  for (unsigned int i = 0; i < node.mNumChildren; ++i)
    walk(file, poses, *node.mChildren[i], placed, depth + 1);
}

}  // namespace

AssimpFile open_assimp(const std::filesystem::path& path, const std::optional<AnimationTime>& at) {
  if (has_ending(path.string(), ".ply")) check_ply(path);
  AssimpFile file;
  file.path = path;
  file.importer = std::make_shared<Assimp::Importer>();
  read(file);
  AssimpPoses poses;
  if (at) {
    poses = pose_assimp(file, *at);
    if (!file.animation.empty())
      file.warnings.push_back(
          fmt::format("{}: between the keys of animation '{}' everything moves in straight lines",
                      path.filename().string(), file.animation));
  } else {
    warn_of_animations(assimp_animation_names(file), path, file.warnings);
  }
  walk(file, poses, *file.scene->mRootNode, {nullptr, world_from_root(*file.scene), false}, 0);
  return file;
}

const AssimpNode* find_node(const AssimpFile& file, const std::string& name) {
  const auto found = std::ranges::find_if(
      file.nodes, [&](const AssimpNode& node) { return name == node.node->mName.C_Str(); });
  return found == file.nodes.end() ? nullptr : &*found;
}

}  // namespace umbrameter

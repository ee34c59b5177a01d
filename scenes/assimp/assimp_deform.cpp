// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/assimp_deform.h"

#include "core/error.h"
#include "scenes/assimp/assimp_values.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <span>

namespace umbrameter {
namespace {

[[noreturn]] void fail_bend(const AssimpFile& file, const std::string& message) {
  fail_input(message, {file.path.string()});
}

/// `rest` is the joint of what has no bones.
void add_influences(const std::vector<JointInfluence>& influences, uint32_t rest, AssimpBoneCounts& counts,
                    Skinning& skinning) {
  double sum = 0.0;
  for (const JointInfluence& influence : influences) sum += influence.weight;
  if (sum == 0.0) {
    skinning.influences.push_back({rest, 1.0});
    ++counts.boneless;
    return;
  }
  if (std::abs(sum - 1.0) > kWeightSumError) ++counts.scaled;
  for (const JointInfluence& influence : influences)
    skinning.influences.push_back({influence.joint, influence.weight / sum});
}

}  // namespace

bool apply_assimp_morphs(const AssimpFile& file, const aiMesh& mesh, const std::string& node,
                         Primitive& primitive) {
  const auto found = file.morph_weights.find(node);
  if (found == file.morph_weights.end()) return false;
  const std::vector<double>& weights = found->second;
  for (size_t i = 0; i < std::min<size_t>(weights.size(), mesh.mNumAnimMeshes); ++i) {
    const aiAnimMesh& target = *mesh.mAnimMeshes[i];  // whole positions, not displacements
    if (weights[i] == 0.0 || target.mVertices == nullptr) continue;
    if (target.mNumVertices != mesh.mNumVertices)
      fail_bend(file, fmt::format("a morph target of mesh '{}' has another number of vertices",
                                  mesh.mName.C_Str()));
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      if (!is_finite(target.mVertices[v]))
        fail_bend(file, fmt::format("a morph target of mesh '{}' is not finite", mesh.mName.C_Str()));
      primitive.vertices[v].p += weights[i] * vector_of(target.mVertices[v] - mesh.mVertices[v]);
      if (target.mNormals != nullptr && primitive.has_normals)
        primitive.vertices[v].n += weights[i] * vector_of(target.mNormals[v] - mesh.mNormals[v]);
    }
  }
  return true;
}

Skinning read_assimp_bones(const AssimpFile& file, const aiMesh& mesh, const glm::dmat4& world_from_node,
                           AssimpBoneCounts& counts) {
  Skinning skinning;
  std::vector<std::vector<JointInfluence>> by_vertex(mesh.mNumVertices);
  for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
    const std::string name = bone->mName.C_Str();
    const AssimpNode* node = find_node(file, name);
    if (node == nullptr)
      fail_bend(file, fmt::format("mesh '{}' has the bone '{}', which is no node", mesh.mName.C_Str(), name));
    const auto joint = static_cast<uint32_t>(skinning.world_from_mesh.size());
    skinning.world_from_mesh.push_back(node->world_from_node * matrix_of(bone->mOffsetMatrix));
    for (const aiVertexWeight& weight : std::span(bone->mWeights, bone->mNumWeights)) {
      if (weight.mVertexId >= mesh.mNumVertices || !(weight.mWeight >= 0.0f) ||
          !std::isfinite(weight.mWeight))
        fail_bend(file, fmt::format("bone '{}' has the weight {} of vertex {} of {}", name, weight.mWeight,
                                    weight.mVertexId, mesh.mNumVertices));
      by_vertex[weight.mVertexId].push_back({joint, weight.mWeight});
    }
  }
  const auto rest = static_cast<uint32_t>(skinning.world_from_mesh.size());
  skinning.world_from_mesh.push_back(world_from_node);
  for (const std::vector<JointInfluence>& influences : by_vertex) {
    skinning.first_influence.push_back(skinning.influences.size());
    add_influences(influences, rest, counts, skinning);
  }
  skinning.first_influence.push_back(skinning.influences.size());
  return skinning;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/assimp_mesh.h"

#include "core/error.h"
#include "scenes/file_ending.h"
#include "scenes/instances.h"
#include "scenes/primitives.h"
#include "scenes/read_mask.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace umbrameter {
namespace {

constexpr std::array<const char*, 4> kEndings = {".fbx", ".dae", ".ply", ".stl"};
constexpr int kDeepest = 1000;  // of nested nodes

glm::dvec3 vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

glm::dmat4 matrix_of(const aiMatrix4x4& m) {
  return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4,
                                   m.d1, m.d2, m.d3, m.d4));
}

bool is_finite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

class AssimpReader {
 public:
  AssimpReader(const std::filesystem::path& path, const MeshFilter& filter,
               std::vector<std::string>& warnings)
      : path_(path), names_(filter), warnings_(warnings) {}

  MeshData read() {
    importer_.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);  // else identifiers
    unsigned int steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_ValidateDataStructure;
    if (has_ending(path_.string(), ".fbx")) steps |= aiProcess_GlobalScale;  // centimetres, mostly, to metres
    scene_ = importer_.ReadFile(path_.string(), steps);
    if (scene_ == nullptr || scene_->mRootNode == nullptr)
      fail(fmt::format("the file cannot be read: {}", importer_.GetErrorString()));
    walk_node(*scene_->mRootNode, glm::dmat4(1.0), 0);
    for (const Shown& shown : shown_) read_shown(shown);
    names_.require_all_seen(path_);
    if (triangle_count_ == 0) fail("the file has no triangles");
    say_what_is_left_out();
    MeshData mesh = assemble_mesh(primitives_, masks_);
    for (const auto& [source, repeated] : repeated_) {
      mesh.repeated.push_back({assemble_mesh({repeated}, masks_), places_[source]});
      keep_used_masks(mesh.repeated.back().mesh);
    }
    mesh.side_files = std::move(side_files_);
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {path_.string()}); }

  struct Shown {
    const aiMesh* mesh;
    const aiNode* node;
    glm::dmat4 world_from_node;
  };

  void walk_node(const aiNode& node, const glm::dmat4& world_from_parent, int depth) {
    if (depth > kDeepest) fail(fmt::format("nodes are nested deeper than {}", kDeepest));
    const glm::dmat4 world_from_node = world_from_parent * matrix_of(node.mTransformation);
    for (int column = 0; column < 4; ++column) {
      const glm::dvec4 values = world_from_node[column];
      if (!(std::abs(values.x) + std::abs(values.y) + std::abs(values.z) < 1e30))
        fail(fmt::format("the transform of node '{}' is not finite", node.mName.C_Str()));
    }
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_->mMeshes[node.mMeshes[i]];
      if (!names_.keeps({material_of(mesh), mesh.mName.C_Str(), node.mName.C_Str()})) continue;
      places_[&mesh].push_back(world_from_node);
      shown_.push_back({&mesh, &node, world_from_node});
      bones_ += mesh.HasBones() ? 1 : 0;
    }
    for (unsigned int i = 0; i < node.mNumChildren; ++i)
      walk_node(*node.mChildren[i], world_from_node, depth + 1);
  }

  std::string material_of(const aiMesh& mesh) const {
    return scene_->mMaterials[mesh.mMaterialIndex]->GetName().C_Str();
  }

  void read_shown(const Shown& shown) {
    if (!is_kept_once(shown.mesh->mNumFaces, places_[shown.mesh])) {
      primitives_.push_back(read_mesh(*shown.mesh, *shown.node, shown.world_from_node));
      return;
    }
    const bool is_known =
        std::ranges::any_of(repeated_, [&](const auto& one) { return one.first == shown.mesh; });
    if (!is_known) repeated_.emplace_back(shown.mesh, read_mesh(*shown.mesh, *shown.node, glm::dmat4(1.0)));
  }

  Primitive read_mesh(const aiMesh& source, const aiNode& node, const glm::dmat4& world_from_mesh) {
    const std::string material = material_of(source), name = source.mName.C_Str();
    Primitive made;
    made.label = !material.empty() ? material : !name.empty() ? name : node.mName.C_Str();
    made.has_normals = source.HasNormals();
    const bool has_uv = source.HasTextureCoords(0);
    made.vertices.resize(source.mNumVertices);
    for (unsigned int i = 0; i < source.mNumVertices; ++i) {
      Primitive::Vertex& vertex = made.vertices[i];
      if (!is_finite(source.mVertices[i])) fail(fmt::format("a vertex of mesh '{}' is not finite", name));
      vertex.p = vector_of(source.mVertices[i]);
      if (made.has_normals && is_finite(source.mNormals[i])) vertex.n = vector_of(source.mNormals[i]);
      if (has_uv) vertex.uv = {source.mTextureCoords[0][i].x, source.mTextureCoords[0][i].y};
    }
    for (unsigned int i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices == 3)
        made.triangles.emplace_back(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
    }
    made.mask = mask_of(source.mMaterialIndex, made, has_uv);
    place(made, world_from_mesh);
    triangle_count_ += made.triangles.size();
    if (triangle_count_ > kMaxTriangles) fail(fmt::format("more than {} triangles", kMaxTriangles));
    return made;
  }

  /// In masks_; absent for what is solid.
  std::optional<uint32_t> mask_of(unsigned int material, const Primitive& primitive, bool has_uv) {
    const auto [known, is_new] = mask_of_material_.try_emplace(material);
    if (is_new) known->second = read_material(*scene_->mMaterials[material]);
    if (!known->second) return {};
    const bool is_in_range =
        std::all_of(primitive.vertices.begin(), primitive.vertices.end(),
                    [](const auto& v) { return std::abs(v.uv.x) <= kMaxUv && std::abs(v.uv.y) <= kMaxUv; });
    if (has_uv && is_in_range) return known->second;
    warn(fmt::format("'{}' has holes, but no texture coordinates that can be used: it is solid",
                     primitive.label));
    return {};
  }

  std::optional<uint32_t> read_material(const aiMaterial& material) {
    aiString picture;
    if (material.GetTexture(aiTextureType_OPACITY, 0, &picture) != aiReturn_SUCCESS) return {};
    std::string name = picture.C_Str();
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path file = path_.parent_path() / std::filesystem::path(name).filename();
    std::error_code ignored;
    side_files_.push_back(file);
    if (!std::filesystem::is_regular_file(file, ignored)) {
      warn(fmt::format("the mask '{}' of material '{}' is not beside the file: it is solid", name,
                       material.GetName().C_Str()));
      return {};
    }
    masks_.push_back(read_mask(file, 1.0f));
    return static_cast<uint32_t>(masks_.size() - 1);
  }

  void warn(const std::string& message) {
    warnings_.push_back(fmt::format("{}: {}", path_.filename().string(), message));
  }

  void say(size_t count, const char* one, const char* many) {
    if (count > 0) warn(fmt::format("{} {}", count, count == 1 ? one : many));
  }

  void say_what_is_left_out() {
    say(bones_, "mesh with bones stands in its rest pose", "meshes with bones stand in their rest pose");
    say(scene_->mNumAnimations, "animation is not read", "animations are not read");
    say(scene_->mNumCameras, "camera is not read", "cameras are not read");
    say(scene_->mNumLights, "light is not read", "lights are not read");
  }

  const std::filesystem::path& path_;
  NameFilter names_;
  std::vector<std::string>& warnings_;
  Assimp::Importer importer_;
  const aiScene* scene_ = nullptr;
  std::map<const aiMesh*, std::vector<glm::dmat4>> places_;
  std::vector<Shown> shown_;
  std::vector<Primitive> primitives_;
  std::vector<std::pair<const aiMesh*, Primitive>> repeated_;  // in their own space
  std::vector<AlphaMask> masks_;
  std::vector<std::filesystem::path> side_files_;
  std::map<unsigned int, std::optional<uint32_t>> mask_of_material_;
  size_t triangle_count_ = 0;
  size_t bones_ = 0;
};

}  // namespace

bool is_read_by_assimp(const std::string& name) {
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return has_ending(name, ending); });
}

MeshData load_assimp_mesh(const std::filesystem::path& path, const MeshFilter& filter,
                          std::vector<std::string>& warnings) {
  return AssimpReader(path, filter, warnings).read();
}

}  // namespace umbrameter

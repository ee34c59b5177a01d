// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/assimp_mesh.h"

#include "core/error.h"
#include "scenes/assimp/assimp_deform.h"
#include "scenes/assimp/assimp_values.h"
#include "scenes/file_ending.h"
#include "scenes/instances.h"
#include "scenes/primitives.h"
#include "scenes/read_mask.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

namespace umbrameter {
namespace {

constexpr std::array<const char*, 4> kEndings = {".fbx", ".dae", ".ply", ".stl"};
class AssimpReader {
 public:
  AssimpReader(const AssimpFile& file, const MeshFilter& filter, std::vector<std::string>& warnings)
      : file_(file),
        path_(file.path),
        scene_(file.scene),
        masks_from_(filter.masks),
        names_(filter),
        warnings_(warnings) {}

  MeshData read() {
    warnings_.insert(warnings_.end(), file_.warnings.begin(), file_.warnings.end());
    for (const AssimpNode& node : file_.nodes) note_node(node);
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
    mesh.animation = file_.animation;
    mesh.moved_views = moved_views();
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {path_.string()}); }

  struct Shown {
    const aiMesh* mesh;
    const AssimpNode* node;
  };

  /// Of a mesh that nothing bends, kept once where several nodes show it.
  bool is_rigid(const aiMesh& mesh, const AssimpNode& node) const {
    return !mesh.HasBones() && file_.morph_weights.count(node.node->mName.C_Str()) == 0;
  }

  void note_node(const AssimpNode& node) {
    for (const unsigned int index : std::span(node.node->mMeshes, node.node->mNumMeshes)) {
      const aiMesh& mesh = *scene_->mMeshes[index];
      if (!names_.keeps({material_of(mesh), mesh.mName.C_Str(), node.node->mName.C_Str()})) continue;
      if (is_rigid(mesh, node)) places_[&mesh].push_back(node.world_from_node);
      shown_.push_back({&mesh, &node});
    }
  }

  size_t moved_views() const {
    size_t count = 0;
    const auto add = [&](const aiString& name) {
      const AssimpNode* node = find_node(file_, name.C_Str());
      count += node != nullptr && node->is_moved ? 1 : 0;
    };
    for (const aiCamera* camera : std::span(scene_->mCameras, scene_->mNumCameras)) add(camera->mName);
    for (const aiLight* light : std::span(scene_->mLights, scene_->mNumLights)) add(light->mName);
    return count;
  }

  std::string material_of(const aiMesh& mesh) const {
    return scene_->mMaterials[mesh.mMaterialIndex]->GetName().C_Str();
  }

  void read_shown(const Shown& shown) {
    const bool is_copied =
        !is_rigid(*shown.mesh, *shown.node) || !is_kept_once(shown.mesh->mNumFaces, places_[shown.mesh]);
    if (is_copied) {
      primitives_.push_back(read_mesh(*shown.mesh, *shown.node, shown.node->world_from_node));
      return;
    }
    const bool is_known =
        std::ranges::any_of(repeated_, [&](const auto& one) { return one.first == shown.mesh; });
    if (!is_known) repeated_.emplace_back(shown.mesh, read_mesh(*shown.mesh, *shown.node, glm::dmat4(1.0)));
  }

  Primitive read_mesh(const aiMesh& source, const AssimpNode& at, const glm::dmat4& world_from_mesh) {
    const aiNode& node = *at.node;
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
    if (source.mNumAnimMeshes > 0 && !apply_assimp_morphs(file_, source, node.mName.C_Str(), made))
      ++unmorphed_;
    if (source.HasBones())
      place_by_joints(made, read_assimp_bones(file_, source, world_from_mesh, bones_));
    else
      place(made, world_from_mesh);
    triangle_count_ += made.triangles.size();
    if (triangle_count_ > kMaxTriangles) fail(fmt::format("more than {} triangles", kMaxTriangles));
    return made;
  }

  /// In masks_; absent for what is solid.
  std::optional<uint32_t> mask_of(unsigned int material, const Primitive& primitive, bool has_uv) {
    if (masks_from_ == MeshMasks::none) return {};
    if (masks_from_ == MeshMasks::given) return has_uv ? std::optional(0u) : std::nullopt;
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
    say(bones_.boneless, "vertex without bones stays with its node",
        "vertices without bones stay with their node");
    say(bones_.scaled, "vertex has bones' weights that do not sum to 1: they are scaled",
        "vertices have bones' weights that do not sum to 1: they are scaled");
    say(unmorphed_, "mesh with morph targets has its base shape",
        "meshes with morph targets have their base shape");
    if (has_ending(path_.string(), ".fbx")) return;  // scenes/assimp/import_assimp.h reads them
    say(scene_->mNumCameras, "camera is not read", "cameras are not read");
    say(scene_->mNumLights, "light is not read", "lights are not read");
  }

  const AssimpFile& file_;
  const std::filesystem::path& path_;
  const aiScene* scene_;
  MeshMasks masks_from_;
  NameFilter names_;
  std::vector<std::string>& warnings_;
  std::map<const aiMesh*, std::vector<glm::dmat4>> places_;
  std::vector<Shown> shown_;
  std::vector<Primitive> primitives_;
  std::vector<std::pair<const aiMesh*, Primitive>> repeated_;  // in their own space
  std::vector<AlphaMask> masks_;
  std::vector<std::filesystem::path> side_files_;
  std::map<unsigned int, std::optional<uint32_t>> mask_of_material_;
  size_t triangle_count_ = 0;
  AssimpBoneCounts bones_;
  size_t unmorphed_ = 0;
};

}  // namespace

bool is_read_by_assimp(const std::string& name) {
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return has_ending(name, ending); });
}

MeshData load_assimp_mesh(const AssimpFile& file, const MeshFilter& filter,
                          std::vector<std::string>& warnings) {
  return AssimpReader(file, filter, warnings).read();
}

MeshData load_assimp_mesh(const std::filesystem::path& path, const MeshFilter& filter,
                          const std::optional<AnimationTime>& at, std::vector<std::string>& warnings) {
  return load_assimp_mesh(open_assimp(path, at), filter, warnings);
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/import_assimp.h"

#include "core/error.h"
#include "scenes/assimp/assimp_mesh.h"
#include "scenes/assimp/assimp_values.h"
#include "scenes/file_ending.h"

#include <assimp/camera.h>
#include <assimp/light.h>
#include <assimp/scene.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cstdio>
#include <span>

namespace umbrameter {
namespace {

using glm::dvec3;

/// Looks along `forward`: what cameras and lights of ours do along -z. Absent where the directions are no use.
std::optional<glm::dmat4> node_from_view(const aiVector3D& place, const aiVector3D& forward,
                                         const aiVector3D& up) {
  const dvec3 back = -vector_of(forward);
  dvec3 right = glm::cross(vector_of(up), back);
  if (!(glm::length(right) > 0.0)) right = glm::cross(dvec3(0, 1, 0), back);
  if (!(glm::length(right) > 0.0)) right = glm::cross(dvec3(0, 0, -1), back);
  if (!(glm::length(right) > 0.0) || !std::isfinite(glm::length(right)) || !is_finite(place))
    return std::nullopt;
  const dvec3 z = glm::normalize(back), x = glm::normalize(right);
  return glm::dmat4(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0),
                    glm::dvec4(vector_of(place), 1));
}

/// A number among a node's properties.
std::optional<double> property(const aiNode& node, const char* key) {
  if (node.mMetaData == nullptr) return std::nullopt;
  double wide = 0.0;
  float narrow = 0.0f;
  int32_t whole = 0;
  if (node.mMetaData->Get(key, wide)) return wide;
  if (node.mMetaData->Get(key, narrow)) return narrow;
  if (node.mMetaData->Get(key, whole)) return whole;
  return std::nullopt;
}

/// A vector, or text as Blender writes lists: "[1.5, 0.5]".
std::optional<glm::dvec2> property_size(const aiNode& node) {
  if (node.mMetaData == nullptr) return std::nullopt;
  aiVector3D vector;
  if (node.mMetaData->Get("size", vector)) return glm::dvec2(vector.x, vector.y);
  aiString text;
  glm::dvec2 size;
  if (node.mMetaData->Get("size", text) && std::sscanf(text.C_Str(), "[%lf, %lf]", &size.x, &size.y) == 2)
    return size;
  return std::nullopt;
}

class AssimpFinder {
 public:
  AssimpFinder(const std::filesystem::path& path, const std::optional<AnimationTime>& at)
      : file_(open_assimp(path, at)) {
    if (at && file_.animation.empty()) fail_not_animated(path, at->time_s);
    found_.path = path;
    found_.at = at;
  }

  FoundScene run() {
    std::vector<std::string> ignored;  // said when the mesh is loaded
    found_.bounds_world = bounds_of(load_assimp_mesh(file_, {}, ignored));
    for (const aiCamera* camera : std::span(file_.scene->mCameras, file_.scene->mNumCameras))
      find_camera(*camera);
    for (const aiLight* light : std::span(file_.scene->mLights, file_.scene->mNumLights)) find_light(*light);
    if (ambient_ > 0)
      warn(fmt::format("{} ambient light{} left out", ambient_, ambient_ == 1 ? " is" : "s are"));
    return std::move(found_);
  }

 private:
  void warn(const std::string& text) {
    found_.warnings.push_back(fmt::format("{}: {}", file_.path.filename().string(), text));
  }

  /// Nodes carry the names of their cameras and lights.
  std::optional<glm::dmat4> place(const char* what, const aiString& name, const aiVector3D& place,
                                  const aiVector3D& forward, const aiVector3D& up) {
    const AssimpNode* node = find_node(file_, name.C_Str());
    const auto own = node_from_view(place, forward, up);
    if (node != nullptr && own) return node->world_from_node * *own;
    warn(fmt::format("{} '{}' {} and is left out", what, name.C_Str(),
                     own ? "stands at no node" : "has no direction"));
    return std::nullopt;
  }

  void find_camera(const aiCamera& camera) {
    const auto world_from_camera =
        place("camera", camera.mName, camera.mPosition, camera.mLookAt, camera.mUp);
    if (!world_from_camera) return;
    // assimp 5.2 gives FBX's whole angle, whatever its own documentation says of half of it.
    const double aspect = camera.mAspect > 0.0f ? camera.mAspect : 1.0;
    const double width_fov_rad = camera.mHorizontalFOV;
    if (!(width_fov_rad > 0.0 && width_fov_rad < glm::radians(180.0))) {
      warn(fmt::format("camera '{}' has a field of view of {:g} degrees and is left out",
                       camera.mName.C_Str(), glm::degrees(width_fov_rad)));
      return;
    }
    const double fov_rad = 2.0 * std::atan(std::tan(0.5 * width_fov_rad) / aspect);
    found_.cameras.push_back(
        {fmt::format("node '{}'", camera.mName.C_Str()), *world_from_camera, glm::degrees(fov_rad)});
  }

  std::optional<FoundLightKind> kind_of(const aiLight& light) {
    switch (light.mType) {
      case aiLightSource_POINT:
        return FoundLightKind::point;
      case aiLightSource_SPOT:
        return FoundLightKind::spot;
      case aiLightSource_DIRECTIONAL:
        return FoundLightKind::sun;
      case aiLightSource_AMBIENT:
        ++ambient_;
        return std::nullopt;
      default:
        return FoundLightKind::area;
    }
  }

  void find_light(const aiLight& light) {
    const auto kind = kind_of(light);
    if (!kind) return;
    const auto world_from_light = place("light", light.mName, light.mPosition, light.mDirection, light.mUp);
    if (!world_from_light) return;
    const aiNode& node = *find_node(file_, light.mName.C_Str())->node;
    std::optional<glm::dvec2> size_world = property_size(node);
    if (!size_world && light.mSize.x > 0.0f && light.mSize.y > 0.0f)
      size_world = glm::dvec2(light.mSize.x, light.mSize.y);
    found_.lights.push_back({light.mName.C_Str(), *kind, *world_from_light, property(node, "radius"),
                             size_world, property(node, "angular_diameter_deg")});
  }

  AssimpFile file_;
  FoundScene found_;
  size_t ambient_ = 0;
};

}  // namespace

bool is_assimp_scene(const std::string& name) {
  return has_ending(name, ".fbx");
}

FoundScene find_assimp_scene(const std::filesystem::path& path, const std::optional<AnimationTime>& at) {
  return AssimpFinder(path, at).run();
}

}  // namespace umbrameter

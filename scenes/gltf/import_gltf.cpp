// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/import_gltf.h"

#include "core/error.h"
#include "scenes/gltf/gltf_mesh.h"
#include "scenes/gltf/tinygltf.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace umbrameter {
namespace {

class GltfFinder {
 public:
  GltfFinder(const std::filesystem::path& path, const std::optional<AnimationTime>& at)
      : file_(open_gltf(path, at)), model_(*file_.model) {
    if (at && file_.animation.empty()) fail_not_animated(path, at->time_s);
    found_.path = path;
    found_.at = at;
  }

  FoundScene run() {
    std::vector<std::string> ignored;  // said when the mesh is loaded
    found_.bounds_world = bounds_of(load_gltf_mesh(file_, {}, ignored));
    for (const GltfNode& node : file_.nodes) {
      find_camera(node);
      find_light(node);
    }
    return std::move(found_);
  }

 private:
  const tinygltf::Node& source(const GltfNode& node) const {
    return model_.nodes[static_cast<size_t>(node.node)];
  }

  void warn(const std::string& text) {
    found_.warnings.push_back(fmt::format("{}: {}", file_.path.filename().string(), text));
  }

  void find_camera(const GltfNode& node) {
    const int index = source(node).camera;
    if (index < 0 || static_cast<size_t>(index) >= model_.cameras.size()) return;
    const tinygltf::Camera& camera = model_.cameras[static_cast<size_t>(index)];
    const std::string name = gltf_node_name(file_, node.node);
    if (camera.type == "perspective")
      found_.cameras.push_back({name, node.world_from_node, glm::degrees(camera.perspective.yfov)});
    else
      warn(fmt::format("the camera of {} is not perspective and is left out", name));
  }

  /// A number in the node's extras, else in the light's.
  std::optional<double> extra(const GltfNode& node, const tinygltf::Light& light, const char* key) const {
    for (const tinygltf::Value* extras : {&source(node).extras, &light.extras}) {
      if (extras->IsObject() && extras->Has(key) && extras->Get(key).IsNumber())
        return extras->Get(key).GetNumberAsDouble();
    }
    return std::nullopt;
  }

  std::optional<glm::dvec2> extra_size(const GltfNode& node, const tinygltf::Light& light) const {
    for (const tinygltf::Value* extras : {&source(node).extras, &light.extras}) {
      if (!extras->IsObject() || !extras->Has("size")) continue;
      const tinygltf::Value& size = extras->Get("size");
      if (!size.IsArray() || size.ArrayLen() != 2 || !size.Get(0).IsNumber() || !size.Get(1).IsNumber())
        continue;
      return glm::dvec2(size.Get(0).GetNumberAsDouble(), size.Get(1).GetNumberAsDouble());
    }
    return std::nullopt;
  }

  static std::optional<FoundLightKind> kind_of(const std::string& type) {
    if (type == "point") return FoundLightKind::point;
    if (type == "spot") return FoundLightKind::spot;
    if (type == "directional") return FoundLightKind::sun;
    return std::nullopt;
  }

  void find_light(const GltfNode& node) {
    const auto named = source(node).extensions.find("KHR_lights_punctual");
    if (named == source(node).extensions.end() || !named->second.Has("light")) return;
    const int index = named->second.Get("light").GetNumberAsInt();
    if (index < 0 || static_cast<size_t>(index) >= model_.lights.size())
      fail_input(fmt::format("{} names light {}, but there are {}", gltf_node_name(file_, node.node), index,
                             model_.lights.size()),
                 {file_.path.string()});
    const tinygltf::Light& light = model_.lights[static_cast<size_t>(index)];
    const std::string& node_name = source(node).name;
    const std::string name = !node_name.empty() ? node_name : !light.name.empty() ? light.name : light.type;
    const auto kind = kind_of(light.type);
    if (!kind) {
      warn(fmt::format("light '{}' is of type '{}', which is not known, and is left out", name, light.type));
      return;
    }
    found_.lights.push_back({name, *kind, node.world_from_node, extra(node, light, "radius"),
                             extra_size(node, light), extra(node, light, "angular_diameter_deg")});
  }

  GltfFile file_;
  const tinygltf::Model& model_;
  FoundScene found_;
};

}  // namespace

FoundScene find_gltf_scene(const std::filesystem::path& path, const std::optional<AnimationTime>& at) {
  return GltfFinder(path, at).run();
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/import_gltf.h"

#include "core/error.h"
#include "core/toml_text.h"
#include "scenes/gltf/gltf_mesh.h"
#include "scenes/gltf/tinygltf.h"
#include "scenes/read_light.h"
#include "scenes/scene_text.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <set>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr double kRadius_world = 0.05;  // of a lamp that has no size
constexpr double kSun_deg = 0.53;       // the real one's

/// Its tangent is the one that follows from the direction.
Light light_of(std::string name, LightType type, const dvec3& center, const dvec3& direction) {
  Light light;
  light.name = std::move(name);
  light.type = type;
  light.center_world = center;
  light.direction_world = direction;
  light.tangent_world = default_tangent(direction);
  return light;
}

class Importer {
 public:
  Importer(const std::filesystem::path& path, const std::filesystem::path& mesh_file)
      : file_(open_gltf(path)),
        model_(*file_.model),
        mesh_file_(mesh_file.empty() ? path.filename() : mesh_file) {
    std::vector<std::string> ignored;  // said when the mesh is loaded
    const MeshData mesh = load_gltf_mesh(file_, {}, ignored);
    for (const dvec3& p : mesh.positions) grow_bounds(p);
    for (const RepeatedMesh& repeated : mesh.repeated) {
      for (const glm::dmat4& place : repeated.world_from_mesh) {
        for (const dvec3& p : repeated.mesh.positions) grow_bounds(dvec3(place * glm::dvec4(p, 1.0)));
      }
    }
  }

  ImportedScene run() {
    imported_.toml = fmt::format("title = {}\n", toml_string(file_.path.stem().string()));
    add_cameras();
    imported_.toml +=
        fmt::format("\n[[mesh]]\nname = {}\nfile = {}\n", toml_string(file_.path.stem().string()),
                    toml_string(mesh_file_.generic_string()));
    add_lights();
    return std::move(imported_);
  }

 private:
  void grow_bounds(const dvec3& p) {
    bounds_.min = glm::min(bounds_.min, p);
    bounds_.max = glm::max(bounds_.max, p);
  }

  const tinygltf::Node& source(const GltfNode& node) const {
    return model_.nodes[static_cast<size_t>(node.node)];
  }

  void warn(const std::string& text) {
    imported_.warnings.push_back(fmt::format("{}: {}", file_.path.filename().string(), text));
  }

  dvec3 middle() const { return 0.5 * (bounds_.min + bounds_.max); }

  /// `at` lies where the middle of the scene is, along the view.
  std::string camera_text(const GltfNode& node, const tinygltf::PerspectiveCamera& camera) const {
    const dvec3 eye(node.world_from_node[3]);
    const dvec3 forward = glm::normalize(-dvec3(node.world_from_node[2]));
    const double ahead = glm::dot(middle() - eye, forward);
    const double distance = ahead > 0.0 ? ahead : 1.0;
    return "[camera]\n" + camera_keys({.eye_world = eye,
                                       .at_world = eye + distance * forward,
                                       .up_world = glm::normalize(dvec3(node.world_from_node[1])),
                                       .vertical_fov_deg = glm::degrees(camera.yfov)});
  }

  static std::string commented(const std::string& text) {
    std::string result = "# ";
    for (const char c : text.substr(0, text.size() - 1))
      result += c == '\n' ? std::string("\n# ") : std::string(1, c);
    return result + "\n";
  }

  void add_cameras() {
    std::vector<std::string> names;
    for (const GltfNode& node : file_.nodes) {
      const int index = source(node).camera;
      if (index < 0 || static_cast<size_t>(index) >= model_.cameras.size()) continue;
      const tinygltf::Camera& camera = model_.cameras[static_cast<size_t>(index)];
      const std::string name = gltf_node_name(file_, node.node);
      if (camera.type != "perspective") {
        warn(fmt::format("the camera of {} is not perspective and is left out", name));
        continue;
      }
      const std::string text = camera_text(node, camera.perspective);
      imported_.toml += "\n# camera of " + name + "\n" + (names.empty() ? text : commented(text));
      names.push_back(name);
    }
    if (names.size() > 1)
      warn(fmt::format("it has {} cameras; the scene is seen from that of {}", names.size(), names.front()));
    if (!names.empty()) return;
    warn("it has no camera; the scene is seen from a corner");
    const double size = glm::length(bounds_.max - bounds_.min);
    imported_.toml += "\n[camera]\n" + camera_keys({.eye_world = middle() + size * dvec3(0.7, 0.6, 0.9),
                                                    .at_world = middle()});
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

  double known_or(const std::optional<double>& value, double fallback, const std::string& name,
                  const char* what) {
    if (value) return *value;
    warn(fmt::format("light '{}' has no {}; {} is taken", name, what, fallback));
    return fallback;
  }

  std::string unique(std::string name) {
    const std::string stem = name;
    for (int number = 2; !light_names_.insert(name).second; ++number)
      name = fmt::format("{}-{}", stem, number);
    return name;
  }

  void add_light(const GltfNode& node, const tinygltf::Light& light) {
    const std::string& node_name = source(node).name;
    const std::string name = unique(!node_name.empty()    ? node_name
                                    : !light.name.empty() ? light.name
                                                          : light.type);
    const dvec3 center(node.world_from_node[3]);
    const dvec3 forward = glm::normalize(-dvec3(node.world_from_node[2]));
    Light found = light_of(name, LightType::sun, center, forward);
    const auto size = extra_size(node, light);
    if (light.type == "directional") {
      found.half_angle_rad = 0.5 * glm::radians(known_or(extra(node, light, "angular_diameter_deg"), kSun_deg,
                                                         name, "angular diameter in degrees"));
    } else if (size) {
      found.type = LightType::rect;
      found.tangent_world = glm::normalize(dvec3(node.world_from_node[0]));
      found.size_world = *size;
    } else {
      const bool is_spot = light.type == "spot";
      if (!is_spot && light.type != "point") {
        warn(
            fmt::format("light '{}' is of type '{}', which is not known, and is left out", name, light.type));
        return;
      }
      if (is_spot) warn(fmt::format("spot '{}' is a disk without the edges of its cone", name));
      const double radius = known_or(extra(node, light, "radius"), kRadius_world, name, "radius in metres");
      // A sphere's direction is where its maps look: at the scene.
      const dvec3 to_middle = middle() - center;
      const dvec3 direction = is_spot || glm::length(to_middle) == 0.0 ? forward : glm::normalize(to_middle);
      found = light_of(name, is_spot ? LightType::disk : LightType::sphere, center, direction);
      found.radius_world = radius;
    }
    imported_.toml += "\n[[light]]\n" + light_keys(found);
  }

  void add_lights() {
    for (const GltfNode& node : file_.nodes) {
      const auto found = source(node).extensions.find("KHR_lights_punctual");
      if (found == source(node).extensions.end() || !found->second.Has("light")) continue;
      const int index = found->second.Get("light").GetNumberAsInt();
      if (index < 0 || static_cast<size_t>(index) >= model_.lights.size())
        fail_input(fmt::format("{} names light {}, but there are {}", gltf_node_name(file_, node.node), index,
                               model_.lights.size()),
                   {file_.path.string()});
      add_light(node, model_.lights[static_cast<size_t>(index)]);
    }
    if (!light_names_.empty()) return;
    warn("it has no light (KHR_lights_punctual); a sun stands high");
    Light sun = light_of({}, LightType::sun, {}, glm::normalize(dvec3(-0.4, -1, -0.3)));
    sun.half_angle_rad = 0.5 * glm::radians(kSun_deg);
    imported_.toml += "\n[[light]]\n" + light_keys(sun);
  }

  GltfFile file_;
  const tinygltf::Model& model_;
  std::filesystem::path mesh_file_;
  Bounds3 bounds_;
  std::set<std::string> light_names_;
  ImportedScene imported_;
};

}  // namespace

ImportedScene import_gltf(const std::filesystem::path& path, const std::filesystem::path& mesh_file) {
  return Importer(path, mesh_file).run();
}

}  // namespace umbrameter

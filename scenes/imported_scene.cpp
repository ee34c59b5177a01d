// SPDX-License-Identifier: Apache-2.0
#include "scenes/imported_scene.h"

#include "core/toml_text.h"
#include "scenes/read_light.h"
#include "scenes/scene_text.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <set>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr double kLamp_radius_world = 0.05;  // of a lamp that has no size
constexpr double kSun_deg = 0.53;            // the real one's

/// Whether an animation or a file has scaled it to nothing.
bool has_axes(const glm::dmat4& world_from_own) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(glm::length(dvec3(world_from_own[axis])) > 1e-12)) return false;
  }
  return true;
}

std::string commented(const std::string& text) {
  std::string result = "# ";
  for (const char c : text.substr(0, text.size() - 1))
    result += c == '\n' ? std::string("\n# ") : std::string(1, c);
  return result + "\n";
}

class SceneWriter {
 public:
  SceneWriter(FoundScene found, const std::filesystem::path& mesh_file)
      : found_(std::move(found)), mesh_file_(mesh_file.empty() ? found_.path.filename() : mesh_file) {
    imported_.warnings = std::move(found_.warnings);
  }

  ImportedScene run() {
    const std::string name = toml_string(found_.path.stem().string());
    imported_.toml = fmt::format("title = {}\n", name);
    add_cameras();
    imported_.toml +=
        fmt::format("\n[[mesh]]\nname = {}\nfile = {}\n", name, toml_string(mesh_file_.generic_string()));
    if (found_.at) add_time(*found_.at);
    for (const Light& light : found_.known_lights) add_known(light);
    for (const FoundLight& light : found_.lights) add_light(light);
    if (light_names_.empty()) add_sun();
    return std::move(imported_);
  }

 private:
  void warn(const std::string& text) {
    imported_.warnings.push_back(fmt::format("{}: {}", found_.path.filename().string(), text));
  }

  dvec3 middle() const { return 0.5 * (found_.bounds_world.min + found_.bounds_world.max); }

  void add_time(const AnimationTime& at) {
    imported_.toml += fmt::format("time = {}\n", toml_number(at.time_s));
    if (!at.animation.empty()) imported_.toml += fmt::format("animation = {}\n", toml_string(at.animation));
  }

  /// `at` lies where the middle of the scene is, along the view.
  std::string camera_text(const FoundCamera& camera) const {
    const dvec3 eye(camera.world_from_camera[3]);
    const dvec3 forward = glm::normalize(-dvec3(camera.world_from_camera[2]));
    const double ahead = glm::dot(middle() - eye, forward);
    const double distance = ahead > 0.0 ? ahead : 1.0;
    return "[camera]\n" + camera_keys({.eye_world = eye,
                                       .at_world = eye + distance * forward,
                                       .up_world = glm::normalize(dvec3(camera.world_from_camera[1])),
                                       .vertical_fov_deg = camera.vertical_fov_deg,
                                       .near_world = camera.near_world});
  }

  void add_cameras() {
    std::vector<std::string> names;
    for (const FoundCamera& camera : found_.cameras) {
      if (!has_axes(camera.world_from_camera)) {
        warn(fmt::format("the camera of {} is scaled to nothing and is left out", camera.name));
        continue;
      }
      const std::string text = camera_text(camera);
      imported_.toml += "\n# camera of " + camera.name + "\n" + (names.empty() ? text : commented(text));
      names.push_back(camera.name);
    }
    if (names.size() > 1)
      warn(fmt::format("it has {} cameras; the scene is seen from that of {}", names.size(), names.front()));
    if (!names.empty()) return;
    warn("it has no camera; the scene is seen from a corner");
    const double size = found_.bounds_world.diagonal();
    imported_.toml += "\n[camera]\n" + camera_keys({.eye_world = middle() + size * dvec3(0.7, 0.6, 0.9),
                                                    .at_world = middle()});
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

  /// A sphere's direction is where its maps look: at the scene.
  dvec3 towards_middle(const dvec3& center, const dvec3& fallback) const {
    const dvec3 to_middle = middle() - center;
    return glm::length(to_middle) > 0.0 ? glm::normalize(to_middle) : fallback;
  }

  void add_known(Light light) {
    light.name = unique(light.name);
    if (light.type == LightType::sphere) {
      light.direction_world = towards_middle(light.center_world, light.direction_world);
      light.tangent_world = default_tangent(light.direction_world);
    }
    imported_.toml += "\n[[light]]\n" + light_keys(light);
  }

  void add_light(const FoundLight& found) {
    if (!has_axes(found.world_from_light)) {
      warn(fmt::format("light '{}' is scaled to nothing and is left out", found.name));
      return;
    }
    const std::string name = unique(found.name);
    const dvec3 center(found.world_from_light[3]);
    const dvec3 forward = glm::normalize(-dvec3(found.world_from_light[2]));
    Light light = light_of(name, LightType::sun, center, forward);
    if (found.kind == FoundLightKind::sun) {
      light.half_angle_rad = 0.5 * glm::radians(known_or(found.angular_diameter_deg, kSun_deg, name,
                                                         "angular diameter in degrees"));
    } else if (found.size_world) {
      light.type = LightType::rect;
      light.tangent_world = glm::normalize(dvec3(found.world_from_light[0]));
      light.size_world = *found.size_world;
    } else {
      light = lamp(found, name, center, forward);
    }
    imported_.toml += "\n[[light]]\n" + light_keys(light);
  }

  Light lamp(const FoundLight& found, const std::string& name, const dvec3& center, const dvec3& forward) {
    const bool is_flat = found.kind != FoundLightKind::point;
    if (found.kind == FoundLightKind::spot)
      warn(fmt::format("spot '{}' is a disk without the edges of its cone", name));
    const double radius_world = known_or(found.radius_world, kLamp_radius_world, name, "radius in metres");
    const dvec3 direction = is_flat ? forward : towards_middle(center, forward);
    Light light = light_of(name, is_flat ? LightType::disk : LightType::sphere, center, direction);
    light.radius_world = radius_world;
    return light;
  }

  void add_sun() {
    warn("it has no light that is read; a sun stands high");
    Light sun = light_of({}, LightType::sun, {}, glm::normalize(dvec3(-0.4, -1, -0.3)));
    sun.half_angle_rad = 0.5 * glm::radians(kSun_deg);
    imported_.toml += "\n[[light]]\n" + light_keys(sun);
  }

  FoundScene found_;
  std::filesystem::path mesh_file_;
  std::set<std::string> light_names_;
  ImportedScene imported_;
};

}  // namespace

Light light_of(std::string name, LightType type, const dvec3& center_world, const dvec3& direction_world) {
  Light light;
  light.name = std::move(name);
  light.type = type;
  light.center_world = center_world;
  light.direction_world = direction_world;
  light.tangent_world = default_tangent(direction_world);
  return light;
}

Bounds3 bounds_of(const MeshData& mesh) {
  Bounds3 bounds;
  const auto grow = [&](const dvec3& p) {
    bounds.min = glm::min(bounds.min, p);
    bounds.max = glm::max(bounds.max, p);
  };
  for (const dvec3& p : mesh.positions) grow(p);
  for (const RepeatedMesh& repeated : mesh.repeated) {
    for (const glm::dmat4& place : repeated.world_from_mesh) {
      for (const dvec3& p : repeated.mesh.positions) grow(dvec3(place * glm::dvec4(p, 1.0)));
    }
  }
  return bounds;
}

ImportedScene write_scene(FoundScene found, const std::filesystem::path& mesh_file) {
  return SceneWriter(std::move(found), mesh_file).run();
}

}  // namespace umbrameter

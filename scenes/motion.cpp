// SPDX-License-Identifier: Apache-2.0
#include "scenes/motion.h"

#include "core/hash.h"
#include "core/names.h"
#include "scenes/scene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace umbrameter {
namespace {

// Fractions of the golden ratio and of the square root of two: no multiple of them is close to a whole number.
constexpr double kGolden = 0.6180339887498949;
constexpr double kAside_px = 3.0 + kGolden;
constexpr double kUp_px = std::numbers::sqrt2;
constexpr double kLightStep = 0.01 * kGolden;

glm::dvec3 camera_step(const Camera& camera, const Motion& motion, int height_px) {
  if (motion.camera_step_px == glm::dvec2(0.0)) return motion.camera_step_world;
  const glm::dvec3 ahead = camera.at_world - camera.eye_world;
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, camera.up_world));
  const glm::dvec3 up = glm::normalize(glm::cross(right, ahead));
  const double half_angle_rad = 0.5 * camera.vertical_fov_deg * std::numbers::pi / 180.0;
  const double px_world = 2.0 * glm::length(ahead) * std::tan(half_angle_rad) / height_px;
  const glm::dvec3 pan = px_world * (motion.camera_step_px.x * right + motion.camera_step_px.y * up);
  return motion.camera_step_world + pan;
}

void move_camera(Camera& camera, const Motion& motion, int frame, int height_px) {
  const glm::dvec3 way = static_cast<double>(frame) * camera_step(camera, motion, height_px);
  camera.eye_world += way;
  camera.at_world += way;
  if (motion.is_cut && frame < 0) camera.at_world = 2.0 * camera.eye_world - camera.at_world;
}

void move_light(Light& light, const Motion& motion, int frame) {
  if (light.type != LightType::sun) {
    light.center_world += static_cast<double>(frame) * motion.light_step_world;
    return;
  }
  const double angle_rad = motion.sun_step_rad * frame;
  const glm::dvec3 direction = light.direction_world, tangent = light.tangent_world;
  light.direction_world = std::cos(angle_rad) * direction + std::sin(angle_rad) * tangent;
  light.tangent_world = std::cos(angle_rad) * tangent - std::sin(angle_rad) * direction;
}

std::set<uint32_t> vertices_of(const Scene& scene, const std::string& object) {
  std::set<uint32_t> vertices;
  for (const MeshPart& part : scene.parts) {
    if (part.name != object) continue;
    for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
      for (int corner = 0; corner < 3; ++corner) vertices.insert(scene.triangles[t][corner]);
  }
  return vertices;
}

void move_object(Scene& scene, const Motion& motion, int frame) {
  const glm::dvec3 way = static_cast<double>(frame) * motion.object_step_world;
  std::vector<glm::vec3>& positions = scene.positions_world.edit();
  for (const uint32_t vertex : vertices_of(scene, motion.object)) {
    const glm::dvec3 p_world = glm::dvec3(positions[vertex]) + way;
    positions[vertex] = glm::vec3(p_world);
    scene.bounds_world.min = glm::min(scene.bounds_world.min, p_world);
    scene.bounds_world.max = glm::max(scene.bounds_world.max, p_world);
  }
  if (!scene.hash.empty()) scene.hash = Hasher().text(scene.hash).text("moved").number(frame).hex();
}

Motion light_motion(const Scene& scene) {
  Motion motion{.name = "light"};
  const Light& light = scene.light();
  const double distance = glm::distance(light.center_world, scene.camera.at_world);
  if (light.type == LightType::sun) {
    motion.sun_step_rad = kLightStep;
  } else {
    motion.light_step_world = distance * kLightStep * light.tangent_world;
  }
  return motion;
}

Motion object_motion(const Scene& scene) {
  if (scene.motion.object.empty())
    fail_input(fmt::format("scene '{}' does not say which object moves", scene.name), scene.source,
               "add [motion] with 'object' and 'object_step'");
  return {
      .name = "object", .object = scene.motion.object, .object_step_world = scene.motion.object_step_world};
}

Motion script_of(const Scene& scene) {
  if (scene.motion.name != Motion{}.name) return scene.motion;
  fail_input(fmt::format("scene '{}' says nothing of motion", scene.name), scene.source, "add [motion]");
}

}  // namespace

std::span<const std::string> motion_names() {
  static const std::array<std::string, 6> names = {"still", "pan", "cut", "light", "object", "script"};
  return names;
}

Motion standard_motion(std::string_view name, const Scene& scene) {
  if (name == "still") return {};
  if (name == "pan") return {.name = "pan", .camera_step_px = {kAside_px, kUp_px}};
  if (name == "cut") return {.name = "cut", .is_cut = true};
  if (name == "light") return light_motion(scene);
  if (name == "object") return object_motion(scene);
  if (name == "script") return script_of(scene);
  fail_input(fmt::format("there is no motion '{}'", name), {},
             suggest_name(name, std::vector<std::string>(motion_names().begin(), motion_names().end())));
}

Scene scene_at(const Scene& scene, int frame, int height_px) {
  Scene moved = scene;
  if (frame == 0) return moved;
  const Motion& motion = scene.motion;
  move_camera(moved.camera, motion, frame, height_px);
  move_light(moved.lights.at(moved.active_light), motion, frame);
  if (motion.object_step_world != glm::dvec3(0.0)) move_object(moved, motion, frame);
  return moved;
}

}  // namespace umbrameter

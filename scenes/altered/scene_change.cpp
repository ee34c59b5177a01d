// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/scene_change.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

Light& light_of(Scene& scene) {
  return scene.lights.at(scene.active_light);
}

const MeshPart& part_of(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.parts, name, &MeshPart::name);
  UMBRAMETER_ASSERT(found != scene.parts.end(), "scene '{}' has no part '{}'", scene.name, name);
  return *found;
}

bool is_in(const MeshPart& part, size_t triangle) {
  return triangle >= part.first_triangle && triangle < part.first_triangle + part.triangle_count;
}

template <class Keep>
Scene only(Scene scene, const Keep& keep) {
  UMBRAMETER_ASSERT(scene.instanced.empty(), "scene '{}' has instances", scene.name);
  std::vector<glm::uvec3> kept;
  std::vector<Cutout> cutouts;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    if (!keep(i)) continue;
    kept.push_back(scene.triangles[i]);
    if (i >= scene.first_cutout()) cutouts.push_back(scene.cutouts[i - scene.first_cutout()]);
  }
  scene.triangles = std::move(kept);
  scene.cutouts = std::move(cutouts);
  scene.parts.clear();  // they no longer count right, and no renderer asks
  scene.hash.clear();
  return scene;
}

bool faces_light(const Scene& scene, size_t triangle) {
  const glm::dvec3 n_world = triangle_normal_world(scene, static_cast<uint32_t>(triangle));
  const Light& light = scene.light();
  if (light.type == LightType::sun) return glm::dot(n_world, light.direction_world) < 0.0;
  const glm::dvec3 p_world = scene.positions_world[scene.triangles[triangle].x];
  return glm::dot(n_world, light.center_world - p_world) > 0.0;
}

}  // namespace

Scene with_light_scaled(Scene scene, double factor) {
  Light& light = light_of(scene);
  light.size_world *= factor;
  light.radius_world *= factor;
  light.half_angle_rad *= factor;
  return scene;
}

Scene with_light_moved(Scene scene, double share) {
  Light& light = light_of(scene);
  const glm::dvec3 direction = light.direction_world, tangent = light.tangent_world;
  if (light.type != LightType::sun) {
    light.center_world += share * glm::length(light.center_world - scene.camera.at_world) * tangent;
    return scene;
  }
  light.direction_world = std::cos(share) * direction + std::sin(share) * tangent;
  light.tangent_world = std::cos(share) * tangent - std::sin(share) * direction;
  return scene;
}

Scene with_light_turned(Scene scene, double angle_rad) {
  Light& light = light_of(scene);
  const glm::dvec3 direction = light.direction_world, bitangent = light.bitangent_world;
  light.direction_world = std::cos(angle_rad) * direction + std::sin(angle_rad) * bitangent;
  light.bitangent_world = std::cos(angle_rad) * bitangent - std::sin(angle_rad) * direction;
  return scene;
}

Scene without_part(Scene scene, std::string_view part) {
  const MeshPart missing = part_of(scene, part);
  return only(std::move(scene), [missing](size_t i) { return !is_in(missing, i); });
}

Scene without_faces_to_light(Scene scene, std::string_view floor_part) {
  const MeshPart floor = part_of(scene, floor_part);
  const Scene whole = scene;
  return only(std::move(scene), [&](size_t i) { return is_in(floor, i) || !faces_light(whole, i); });
}

}  // namespace umbrameter

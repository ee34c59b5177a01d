// SPDX-License-Identifier: Apache-2.0
#include "scenes/foreign/lamps.h"

#include "scenes/read_light.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using glm::dvec3;

bool has_direction(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length);
}

bool is_uneven(const glm::dmat4& m) {
  constexpr double kSloppy = 1e-4;
  const double x = glm::length(dvec3(m[0])), y = glm::length(dvec3(m[1])), z = glm::length(dvec3(m[2]));
  return std::abs(x - z) > kSloppy * z || std::abs(y - z) > kSloppy * z;
}

/// Where something stands that looks along `ahead`, which is unit: x, y and -z of it.
glm::dmat4 world_from_looking(const dvec3& position, const dvec3& ahead, const dvec3& up) {
  const dvec3 right = glm::normalize(glm::cross(ahead, up));
  return {glm::dvec4(right, 0), glm::dvec4(glm::cross(right, ahead), 0), glm::dvec4(-ahead, 0),
          glm::dvec4(position, 1)};
}

void add_lamp(const std::string& name, FoundLightKind kind, const dvec3& position, const dvec3& direction,
              ForeignScene& scene) {
  if (!has_direction(direction)) {
    scene.of_views.add("light without a direction is left out", "lights without a direction are left out");
    return;
  }
  const dvec3 ahead = glm::normalize(direction);
  scene.lamps.push_back(
      {name, kind, world_from_looking(position, ahead, default_tangent(ahead)), {}, {}, {}});
}

}  // namespace

void add_point_lamp(const std::string& name, const dvec3& center_world, ForeignScene& scene) {
  add_lamp(name, FoundLightKind::point, center_world, dvec3(0, -1, 0), scene);
}

void add_spot_lamp(const std::string& name, const dvec3& center_world, const dvec3& direction_world,
                   ForeignScene& scene) {
  add_lamp(name, FoundLightKind::spot, center_world, direction_world, scene);
}

void add_distant_lamp(const std::string& name, const dvec3& direction_world, ForeignScene& scene) {
  add_lamp(name, FoundLightKind::sun, dvec3(0.0), direction_world, scene);
}

FoundCamera foreign_camera(const std::string& name, const glm::dmat4& world_from_camera, int width_px,
                           int height_px, ForeignScene& scene, const FileLocation& where) {
  const dvec3 ahead(world_from_camera[2]), up(world_from_camera[1]);
  if (!has_direction(ahead) || !has_direction(up) || !has_direction(glm::cross(ahead, up)))
    fail_input(fmt::format("the transform of {} has no direction", name), where);
  if (is_uneven(world_from_camera))
    scene.of_views.add("camera with an uneven scale is read without it",
                       "cameras with an uneven scale are read without it");
  FoundCamera camera;
  camera.name = fmt::format("{} ({} x {} px)", name, width_px, height_px);
  camera.world_from_camera =
      world_from_looking(dvec3(world_from_camera[3]), glm::normalize(ahead), glm::normalize(up));
  return camera;
}

}  // namespace umbrameter

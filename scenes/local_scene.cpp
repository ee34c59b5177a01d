// SPDX-License-Identifier: Apache-2.0
#include "scenes/local_scene.h"

#include "scenes/instances.h"

#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kFar = 16.0;  // diagonals; nearer, floats lose less than 4 of their 24 bits

/// A round number near `middle`, if that is far away. Positions and it are multiples of the spacing of floats there, and
/// their difference is small: it is exact.
double origin_along(double middle, double diagonal) {
  if (std::abs(middle) < kFar * diagonal || diagonal == 0.0) return 0.0;
  const double step = std::exp2(std::floor(std::log2(diagonal)));
  return std::round(middle / step) * step;
}

std::shared_ptr<const InstancedMesh> moved_by(const InstancedMesh& mesh, const glm::dvec3& offset_world) {
  auto moved = std::make_shared<InstancedMesh>(mesh);
  for (glm::mat4x3& place : moved->world_from_mesh) place[3] = glm::vec3(glm::dvec3(place[3]) + offset_world);
  return moved;
}

}  // namespace

std::optional<LocalScene> local_scene(const Scene& scene) {
  if (scene.bounds_world.empty()) return std::nullopt;
  const glm::dvec3 middle = 0.5 * (scene.bounds_world.min + scene.bounds_world.max);
  const double diagonal = scene.bounds_world.diagonal();
  const glm::dvec3 origin(origin_along(middle.x, diagonal), origin_along(middle.y, diagonal),
                          origin_along(middle.z, diagonal));
  if (origin == glm::dvec3(0.0)) return std::nullopt;
  LocalScene local{scene, origin};
  Scene& moved = local.scene;
  for (glm::vec3& p : moved.positions_world.edit()) p = glm::vec3(glm::dvec3(p) - origin);
  for (auto& mesh : moved.instanced) mesh = moved_by(*mesh, -origin);
  moved.camera.eye_world -= origin;
  moved.camera.at_world -= origin;
  for (Light& light : moved.lights) light.center_world -= origin;
  moved.bounds_world.min -= origin;
  moved.bounds_world.max -= origin;
  return local;
}

void add_origin(const glm::dvec3& origin_world, Image& image) {
  constexpr std::array kChannels = {"position.x", "position.y", "position.z"};
  const auto primitive = image.plane("primitive_id");
  for (int axis = 0; axis < 3; ++axis) {
    const auto plane = image.plane(kChannels[static_cast<size_t>(axis)]);
    for (size_t i = 0; i < plane.size(); ++i) {
      if (primitive[i] >= 0.0f)
        plane[i] = static_cast<float>(static_cast<double>(plane[i]) + origin_world[axis]);
    }
  }
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/render_keys.h"

#include "core/hash.h"
#include "scenes/scene_hash.h"

#include <span>

namespace umbrameter {
namespace {

void hash_vector(Hasher& hasher, const glm::dvec3& v) {
  hasher.number(v.x).number(v.y).number(v.z);
}

}  // namespace

std::string geometry_key(const Scene& scene) {
  if (!scene.hash.empty()) return scene.hash;
  Hasher hasher;
  hasher.values(std::span<const glm::vec3>(scene.positions_world));
  hasher.values(std::span<const glm::vec3>(scene.normals_world));
  hasher.values(std::span<const glm::uvec3>(scene.triangles));
  hash_cutouts(hasher, scene);
  hash_instances(hasher, scene);
  return hasher.hex();
}

std::string picture_key(const Scene& scene, const RenderRequest& request) {
  Hasher hasher;
  hasher.text(geometry_key(scene)).number(request.width_px).number(request.height_px);
  hash_vector(hasher, scene.camera.eye_world);
  hash_vector(hasher, scene.camera.at_world);
  hash_vector(hasher, scene.camera.up_world);
  hasher.number(scene.camera.vertical_fov_deg).number(scene.camera.near_world);
  const Light& light = scene.light();
  hasher.number(static_cast<double>(light.type));
  hash_vector(hasher, light.center_world);
  hash_vector(hasher, light.tangent_world);
  hash_vector(hasher, light.bitangent_world);
  hash_vector(hasher, light.direction_world);
  hasher.number(light.size_world.x).number(light.size_world.y).number(light.radius_world);
  return hasher.number(light.half_angle_rad).hex();
}

}  // namespace umbrameter

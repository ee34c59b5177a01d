// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_hash.h"

#include "core/hash.h"
#include "scenes/instances.h"

namespace umbrameter {
namespace {

void hash_vector(Hasher& hasher, const glm::dvec3& v) {
  hasher.number(v.x).number(v.y).number(v.z);
}

void hash_light(Hasher& hasher, const Light& light) {
  hasher.text(to_text(light.type));
  for (const glm::dvec3& v :
       {light.center_world, light.tangent_world, light.bitangent_world, light.direction_world}) {
    hash_vector(hasher, v);
  }
  hasher.number(light.size_world.x)
      .number(light.size_world.y)
      .number(light.radius_world)
      .number(light.half_angle_rad);
}

void hash_holes(Hasher& hasher, std::span<const Cutout> cutouts, std::span<const AlphaMask> masks) {
  hasher.values(cutouts);
  for (const AlphaMask& mask : masks)
    hasher.number(mask.width).number(mask.height).values(std::span<const uint32_t>(mask.bits));
}

/// Nothing for a scene that stands still as long as its techniques like.
void hash_motion(Hasher& hasher, const Motion& motion) {
  const Motion still;
  if (motion.frames_before) hasher.text("frames before").number(*motion.frames_before);
  if (motion.name == still.name) return;
  hasher.text(motion.name).number(motion.camera_step_px.x).number(motion.camera_step_px.y);
  for (const glm::dvec3& step : {motion.camera_step_world, motion.light_step_world, motion.object_step_world})
    hash_vector(hasher, step);
  hasher.number(motion.is_cut ? 1.0 : 0.0).number(motion.sun_step_rad).text(motion.object);
}

}  // namespace

void hash_cutouts(Hasher& hasher, const Scene& scene) {
  if (scene.cutouts.empty()) return;
  hash_holes(hasher, scene.cutouts, scene.masks);
}

void hash_instances(Hasher& hasher, const Scene& scene) {
  for (const auto& mesh : scene.instanced) {
    hasher.text("instanced");
    hasher.number(static_cast<double>(mesh->positions.size())).values(std::span(mesh->positions));
    hasher.number(static_cast<double>(mesh->normals.size())).values(std::span(mesh->normals));
    hasher.values(std::span(mesh->triangles));
    hash_holes(hasher, mesh->cutouts, mesh->masks);
    hasher.number(static_cast<double>(mesh->world_from_mesh.size())).values(std::span(mesh->world_from_mesh));
  }
}

std::string hash_scene(const Scene& scene) {
  Hasher hasher;
  for (const glm::dvec3& v : {scene.camera.eye_world, scene.camera.at_world, scene.camera.up_world}) {
    hash_vector(hasher, v);
  }
  hasher.number(scene.camera.vertical_fov_deg).number(scene.camera.near_world);
  hasher.number(static_cast<double>(scene.lights.size()));
  for (const Light& light : scene.lights) hash_light(hasher, light);
  hasher.number(static_cast<double>(scene.positions_world.size()));
  hasher.values(std::span<const glm::vec3>(scene.positions_world));
  hasher.number(static_cast<double>(scene.normals_world.size()));
  hasher.values(std::span<const glm::vec3>(scene.normals_world));
  hasher.values(std::span<const glm::uvec3>(scene.triangles));
  hash_cutouts(hasher, scene);
  hash_instances(hasher, scene);
  hash_motion(hasher, scene.motion);
  return hasher.hex();
}

}  // namespace umbrameter

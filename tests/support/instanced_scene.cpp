// SPDX-License-Identifier: Apache-2.0
#include "tests/support/instanced_scene.h"

#include "scenes/merge_meshes.h"
#include "scenes/scene_hash.h"
#include "scenes/shapes.h"
#include "tests/support/cutout_card.h"

#include <glm/gtc/matrix_transform.hpp>

namespace umbrameter {
namespace {

void append_to(MeshData& mesh, MeshData more) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  for (const glm::uvec3& t : more.triangles) mesh.triangles.push_back(t + base);
}

/// Upright in the plane z = 0.1 (x + y), in front of the crown, with leaves out of its middle.
void add_leaves(MeshData& mesh) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (const glm::dvec2& p : {glm::dvec2(-0.7, 0.4), {0.7, 0.4}, {0.7, 1.6}, {-0.7, 1.6}})
    mesh.positions.emplace_back(p.x, p.y, 0.5 + 0.1 * (p.x + p.y));
  if (!mesh.normals.empty())
    mesh.normals.insert(mesh.normals.end(), 4, glm::normalize(glm::dvec3(-0.1, -0.1, 1)));
  mesh.cutout_of_triangle.assign(mesh.triangles.size(), kSolid);
  for (uint32_t k = 0; k < 2; ++k) {
    mesh.triangles.emplace_back(base, base + 1 + k, base + 2 + k);
    mesh.cutout_of_triangle.push_back(k);
    mesh.cutouts.push_back({{glm::vec2(0, 0), k == 0 ? glm::vec2(2, 0) : glm::vec2(2, 2),
                             k == 0 ? glm::vec2(2, 2) : glm::vec2(0, 2)},
                            0});
  }
  mesh.masks.push_back(pattern_mask({"#.#.", "....", ".##.", "#..."}));
}

/// A crown on a stem, taller than wide and not alike from any side.
MeshData tree(const InstancedSceneOptions& options) {
  MeshData mesh = make_sphere(0.4, 16, options.is_smooth);
  for (glm::dvec3& p : mesh.positions) p = {1.2 * p.x, p.y + 1.0, 0.8 * p.z + 0.2 * p.x};
  MeshData stem = make_box({0.15, 0.7, 0.25});
  if (options.is_smooth) split_flat(stem);
  append_to(mesh, std::move(stem));
  if (options.has_leaves) add_leaves(mesh);
  return mesh;
}

std::vector<glm::dmat4> places() {
  const glm::dmat4 one(1.0);
  const glm::dvec3 up(0, 1, 0);
  const auto at = [&](double x, double z) { return glm::translate(one, glm::dvec3(x, 0, z)); };
  return {at(-1.6, -0.9),
          glm::rotate(at(0.1, -1.2), 0.9, up),
          glm::scale(at(1.7, -0.8), glm::dvec3(0.6)),
          glm::scale(glm::rotate(at(-1.2, 0.9), 0.4, glm::dvec3(0.1, 1, 0.2)), glm::dvec3(1.5, 0.7, 0.9)),
          glm::scale(at(0.3, 0.8), glm::dvec3(-1, 1, 1)),
          glm::scale(glm::rotate(at(1.5, 0.9), -1.3, up), glm::dvec3(0.8, 1.1, -1.3))};
}

}  // namespace

Scene instanced_scene(const Light& light, const InstancedSceneOptions& options) {
  std::vector<NamedMesh> meshes(2);
  meshes[0].name = "floor";
  meshes[0].mesh = make_plane({8, 6});
  meshes[1].name = "tree";
  meshes[1].mesh.repeated.push_back({tree(options), places()});
  Scene scene;
  scene.name = "instanced";
  merge_meshes(meshes, scene);
  scene.lights = {light};
  scene.camera = {.eye_world = {1.5, 3.2, 4.5}, .at_world = {0, 0.4, 0}, .near_world = 1e-3};
  scene.hash = hash_scene(scene);
  return scene;
}

}  // namespace umbrameter

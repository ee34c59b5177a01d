// SPDX-License-Identifier: Apache-2.0
#include "scenes/instances.h"
#include "scenes/merge_meshes.h"
#include "scenes/read_values.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

using glm::dvec3;

/// Through the plane x = 0, with its outside outside.
MeshData mirror_image(MeshData mesh) {
  for (dvec3& p : mesh.positions) p.x = -p.x;
  for (dvec3& n : mesh.normals) n.x = -n.x;
  for (Cutout& cutout : mesh.cutouts) std::swap(cutout.uv[1], cutout.uv[2]);
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  return mesh;
}

/// Through x = 0 before the place itself: it no longer mirrors.
glm::dmat4 unmirrored(glm::dmat4 world_from_mesh) {
  world_from_mesh[0] = -world_from_mesh[0];
  return world_from_mesh;
}

std::vector<glm::mat4x3> float_places(const std::vector<glm::dmat4>& places) {
  std::vector<glm::mat4x3> floats;
  for (const glm::dmat4& m : places)
    floats.emplace_back(glm::vec3(m[0]), glm::vec3(m[1]), glm::vec3(m[2]), glm::vec3(m[3]));
  return floats;
}

/// Says how many there were.
size_t drop_repeated(std::vector<glm::mat4x3>& places) {
  const auto key = [](const glm::mat4x3& m) {
    std::array<float, 12> values{};
    for (int i = 0; i < 12; ++i) values[static_cast<size_t>(i)] = m[i / 3][i % 3];
    return values;
  };
  std::vector<size_t> order(places.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, [&](size_t i, size_t j) { return key(places[i]) < key(places[j]); });
  std::vector<bool> is_repeated(places.size(), false);
  for (size_t i = 1; i < order.size(); ++i) is_repeated[order[i]] = places[order[i]] == places[order[i - 1]];
  std::vector<glm::mat4x3> kept;
  for (size_t i = 0; i < places.size(); ++i) {
    if (!is_repeated[i]) kept.push_back(places[i]);
  }
  const size_t dropped = places.size() - kept.size();
  places = std::move(kept);
  return dropped;
}

/// Cleaned as any other mesh is, in a space of its own.
InstancedMesh cleaned(const NamedMesh& owner, MeshData mesh, bool is_smooth, Scene& scene) {
  if (is_smooth && mesh.normals.empty()) split_flat(mesh);
  std::vector<NamedMesh> alone;
  alone.push_back({owner.name, owner.label, owner.where, std::move(mesh)});
  Scene own;
  merge_meshes(alone, own);
  scene.warnings.insert(scene.warnings.end(), own.warnings.begin(), own.warnings.end());
  return {own.positions_world, own.normals_world, own.triangles,    own.parts,
          own.cutouts,         own.masks,         own.bounds_world, {}};
}

void grow_bounds(const NamedMesh& owner, const Instance& instance, Scene& scene) {
  for (uint32_t v = 0; v < instance.mesh->positions.size(); ++v) {
    const dvec3 p = instance.p_world(v);
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMaxLength_world))
      fail_input(
          fmt::format(
              "an instance of mesh '{}' has a vertex at ({}, {}, {}); coordinates must stay within {:g}",
              owner.name, p.x, p.y, p.z, kMaxLength_world),
          owner.where, "check where its nodes stand");
    scene.bounds_world.min = glm::min(scene.bounds_world.min, p);
    scene.bounds_world.max = glm::max(scene.bounds_world.max, p);
  }
}

uint64_t stored_triangles(const Scene& scene) {
  uint64_t count = scene.triangles.size();
  for (const auto& mesh : scene.instanced) count += mesh->triangles.size();
  return count;
}

void require_countable(const NamedMesh& owner, const Scene& scene) {
  const uint64_t stored = stored_triangles(scene), shown = count_shown_triangles(scene);
  if (stored > kMaxTriangles)
    fail_input(fmt::format("with mesh '{}' the scene has {} triangles; at most {} can be told apart",
                           owner.name, stored, kMaxTriangles),
               owner.where);
  if (shown > kMaxShownTriangles)
    fail_input(
        fmt::format(
            "with the instances of mesh '{}' the scene shows {} triangles; at most {} can be told apart",
            owner.name, shown, kMaxShownTriangles),
        owner.where);
}

void add_mesh(const NamedMesh& owner, MeshData data, const std::vector<glm::dmat4>& places, bool is_smooth,
              Scene& scene) {
  if (places.empty()) return;
  auto mesh = std::make_shared<InstancedMesh>(cleaned(owner, std::move(data), is_smooth, scene));
  mesh->world_from_mesh = float_places(places);
  if (const size_t dropped = drop_repeated(mesh->world_from_mesh); dropped > 0)
    scene.warnings.push_back(fmt::format("{}: dropped {} instance{} that stood where another does",
                                         owner.label, dropped, dropped == 1 ? "" : "s"));
  for (const glm::mat4x3& place : mesh->world_from_mesh) grow_bounds(owner, {mesh.get(), &place, 0}, scene);
  scene.instanced.push_back(std::move(mesh));
  require_countable(owner, scene);
}

}  // namespace

void add_instances(NamedMesh& owner, bool is_smooth, Scene& scene) {
  for (RepeatedMesh& repeated : owner.mesh.repeated) {
    std::vector<glm::dmat4> straight, mirrored;
    for (const glm::dmat4& place : repeated.world_from_mesh) {
      if (glm::determinant(glm::dmat3(place)) > 0.0)
        straight.push_back(place);
      else
        mirrored.push_back(unmirrored(place));
    }
    if (!mirrored.empty()) add_mesh(owner, mirror_image(repeated.mesh), mirrored, is_smooth, scene);
    add_mesh(owner, std::move(repeated.mesh), straight, is_smooth, scene);
  }
  owner.mesh.repeated.clear();
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/instances.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

/// Columns are exact in double.
glm::dmat3 linear_part(const glm::mat4x3& m) {
  return {glm::dvec3(m[0]), glm::dvec3(m[1]), glm::dvec3(m[2])};
}

}  // namespace

glm::dvec3 Instance::p_world(uint32_t vertex) const {
  const glm::mat4x3& m = *world_from_mesh;
  return linear_part(m) * glm::dvec3(mesh->positions[vertex]) + glm::dvec3(m[3]);
}

glm::dvec3 Instance::n_world(uint32_t vertex) const {
  const glm::dmat3 m = linear_part(*world_from_mesh);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::normalize(cofactors * glm::dvec3(mesh->normals[vertex]));
}

std::array<glm::dvec3, 3> Instance::corners_world(uint32_t triangle) const {
  const glm::uvec3& t = mesh->triangles[triangle];
  return {p_world(t.x), p_world(t.y), p_world(t.z)};
}

Bounds3 Instance::bounds_world() const {
  const glm::mat4x3& m = *world_from_mesh;
  const glm::dvec3 middle = linear_part(m) * (0.5 * (mesh->bounds.min + mesh->bounds.max)) + glm::dvec3(m[3]);
  const glm::dvec3 half = 0.5 * (mesh->bounds.max - mesh->bounds.min);
  glm::dvec3 reach(0.0);
  for (int k = 0; k < 3; ++k) reach += glm::abs(glm::dvec3(m[k])) * half[k];
  constexpr double kRoundoffs = 0x1p-21;  // a few of float's: Embree moves rays, not corners
  reach += kRoundoffs * (glm::abs(middle) + reach);
  return {middle - reach, middle + reach};
}

std::vector<Instance> list_instances(const Scene& scene) {
  std::vector<Instance> instances;
  auto next = static_cast<uint32_t>(scene.triangles.size());
  for (const auto& mesh : scene.instanced) {
    for (const glm::mat4x3& place : mesh->world_from_mesh) {
      instances.push_back({mesh.get(), &place, next});
      next += static_cast<uint32_t>(mesh->triangles.size());
    }
  }
  return instances;
}

uint64_t count_shown_triangles(const Scene& scene) {
  uint64_t count = scene.triangles.size();
  for (const auto& mesh : scene.instanced) count += mesh->world_from_mesh.size() * mesh->triangles.size();
  return count;
}

uint64_t count_shown_cutouts(const Scene& scene) {
  uint64_t count = scene.cutouts.size();
  for (const auto& mesh : scene.instanced) count += mesh->world_from_mesh.size() * mesh->cutouts.size();
  return count;
}

bool has_shading_normals(const Scene& scene) {
  return !scene.normals_world.empty() ||
         (!scene.instanced.empty() && !scene.instanced.front()->normals.empty());
}

bool squashes(const glm::dmat4& world_from_mesh) {
  constexpr double kFlattest = 1e-4;  // of the cube of the longest side
  const glm::dmat3 m(world_from_mesh);
  const double longest = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  return !(std::abs(glm::determinant(m)) > kFlattest * longest * longest * longest);
}

bool is_kept_once(uint64_t triangles, std::span<const glm::dmat4> world_from_mesh) {
  const auto squashed = static_cast<size_t>(std::ranges::count_if(world_from_mesh, squashes));
  const size_t places = world_from_mesh.size() - squashed;
  return places >= 2 && (places - 1) * triangles >= kLeastCopiedTriangles;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/clean_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <tuple>

namespace umbrameter {
namespace {

/// The smallest index of a vertex with the same position, for each vertex.
std::vector<uint32_t> merge_equal_positions(std::span<const glm::vec3> positions) {
  std::vector<uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](uint32_t i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<uint32_t> first(positions.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

bool has_area(const Scene& scene, const glm::uvec3& triangle) {
  const glm::dvec3 a(scene.positions_world[triangle.x]);
  const glm::dvec3 b(scene.positions_world[triangle.y]);
  const glm::dvec3 c(scene.positions_world[triangle.z]);
  return glm::cross(b - a, c - a) != glm::dvec3(0.0);
}

void mark_duplicates(std::span<const glm::uvec3> triangles, const std::vector<uint32_t>& vertex,
                     std::vector<TriangleFault>& faults) {
  std::vector<std::array<uint32_t, 4>> keys;  // three positions in order, triangle
  keys.reserve(triangles.size());
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    if (faults[t] != TriangleFault::none) continue;
    std::array<uint32_t, 4> key{vertex[triangles[t].x], vertex[triangles[t].y], vertex[triangles[t].z], t};
    std::sort(key.begin(), key.begin() + 3);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  for (size_t i = 1; i < keys.size(); ++i) {
    if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin())) {
      faults[keys[i][3]] = TriangleFault::duplicate;
    }
  }
}

void remove_unused_vertices(Scene& scene) {
  constexpr uint32_t kUnused = ~0u;
  std::vector<uint32_t> renumbered(scene.positions_world.size(), kUnused);
  for (const glm::uvec3& t : scene.triangles) renumbered[t.x] = renumbered[t.y] = renumbered[t.z] = 0;
  uint32_t next = 0;
  std::vector<glm::vec3>& positions = scene.positions_world.edit();
  std::vector<glm::vec3>& normals = scene.normals_world.edit();
  for (size_t i = 0; i < renumbered.size(); ++i) {
    if (renumbered[i] == kUnused) continue;
    positions[next] = positions[i];
    if (!normals.empty()) normals[next] = normals[i];
    renumbered[i] = next++;
  }
  positions.resize(next);
  positions.shrink_to_fit();
  if (!normals.empty()) normals.resize(next);
  normals.shrink_to_fit();
  for (glm::uvec3& t : scene.triangles.edit()) t = {renumbered[t.x], renumbered[t.y], renumbered[t.z]};
}

}  // namespace

std::vector<TriangleFault> find_triangle_faults(const Scene& scene) {
  std::vector<TriangleFault> faults(scene.triangles.size(), TriangleFault::none);
  for (size_t t = 0; t < faults.size(); ++t) {
    if (!has_area(scene, scene.triangles[t])) faults[t] = TriangleFault::zero_area;
  }
  mark_duplicates(scene.triangles, merge_equal_positions(scene.positions_world), faults);
  return faults;
}

void remove_triangles(Scene& scene, const std::vector<TriangleFault>& faults) {
  uint32_t next = 0;
  std::vector<glm::uvec3>& triangles = scene.triangles.edit();
  for (MeshPart& part : scene.parts) {
    const uint32_t first = next;
    for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      if (faults[t] == TriangleFault::none) triangles[next++] = triangles[t];
    }
    part.first_triangle = first;
    part.triangle_count = next - first;
  }
  triangles.resize(next);
  triangles.shrink_to_fit();
  std::erase_if(scene.parts, [](const MeshPart& part) { return part.triangle_count == 0; });
  remove_unused_vertices(scene);
}

}  // namespace umbrameter

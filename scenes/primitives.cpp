// SPDX-License-Identifier: Apache-2.0
#include "scenes/primitives.h"

#include "core/error.h"
#include "core/names.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using glm::dvec3;

bool can_normalize(const dvec3& n) {
  const double length = glm::length(n);
  return length > 0.0 && std::isfinite(length);
}

glm::uvec3 flat_triangle(const Primitive& one, const glm::uvec3& t, MeshData& mesh) {
  const dvec3 &a = one.vertices[t.x].p, &b = one.vertices[t.y].p, &c = one.vertices[t.z].p;
  const dvec3 n = glm::cross(b - a, c - a);
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.normals.insert(mesh.normals.end(), 3, can_normalize(n) ? glm::normalize(n) : dvec3(0, 1, 0));
  return {first, first + 1, first + 2};
}

void append(const Primitive& one, bool is_smooth, MeshData& mesh) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (const Primitive::Vertex& vertex : one.vertices) {
    mesh.positions.push_back(vertex.p);
    if (is_smooth) mesh.normals.push_back(can_normalize(vertex.n) ? vertex.n : dvec3(0, 1, 0));
  }
  for (const glm::uvec3& t : one.triangles) {
    const bool is_usable = can_normalize(one.vertices[t.x].n) && can_normalize(one.vertices[t.y].n) &&
                           can_normalize(one.vertices[t.z].n);
    mesh.triangles.push_back(is_smooth && !is_usable ? flat_triangle(one, t, mesh) : t + base);
    mesh.cutout_of_triangle.push_back(one.mask ? static_cast<uint32_t>(mesh.cutouts.size()) : kSolid);
    if (!one.mask) continue;
    mesh.cutouts.push_back({{one.vertices[t.x].uv, one.vertices[t.y].uv, one.vertices[t.z].uv}, *one.mask});
  }
}

}  // namespace

void place(Primitive::Vertex& vertex, const glm::dmat4& world_from_node) {
  // The cofactors: right for mirrored and flattened nodes, too.
  const glm::dmat3 m(world_from_node);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const double side = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
  vertex.p = dvec3(world_from_node * glm::dvec4(vertex.p, 1.0));
  const dvec3 n = side * (cofactors * vertex.n);
  vertex.n = can_normalize(n) ? glm::normalize(n) : dvec3(0.0);
}

void place(Primitive& primitive, const glm::dmat4& world_from_node) {
  for (Primitive::Vertex& vertex : primitive.vertices) place(vertex, world_from_node);
  if (glm::determinant(glm::dmat3(world_from_node)) >= 0.0) return;
  for (glm::uvec3& t : primitive.triangles) std::swap(t.y, t.z);
}

MeshData assemble_mesh(const std::vector<Primitive>& primitives, std::vector<AlphaMask> masks) {
  MeshData mesh;
  mesh.masks = std::move(masks);
  const bool is_smooth =
      std::any_of(primitives.begin(), primitives.end(), [](const Primitive& one) { return one.has_normals; });
  std::vector<std::string> labels;
  for (const Primitive& one : primitives) {
    if (std::find(labels.begin(), labels.end(), one.label) == labels.end()) labels.push_back(one.label);
  }
  for (const std::string& label : labels) {
    const auto first = static_cast<uint32_t>(mesh.triangles.size());
    for (const Primitive& one : primitives) {
      if (one.label == label) append(one, is_smooth, mesh);
    }
    mesh.parts.push_back({label, first, static_cast<uint32_t>(mesh.triangles.size()) - first});
  }
  if (mesh.cutouts.empty()) mesh.cutout_of_triangle.clear();
  return mesh;
}

void keep_used_masks(MeshData& mesh) {
  constexpr uint32_t kUnused = ~0u;
  std::vector<uint32_t> renumbered(mesh.masks.size(), kUnused);
  std::vector<AlphaMask> used;
  for (Cutout& cutout : mesh.cutouts) {
    uint32_t& number = renumbered[cutout.mask];
    if (number == kUnused) {
      number = static_cast<uint32_t>(used.size());
      used.push_back(std::move(mesh.masks[cutout.mask]));
    }
    cutout.mask = number;
  }
  mesh.masks = std::move(used);
}

bool NameFilter::keeps(const std::set<std::string>& names) {
  seen_.insert(names.begin(), names.end());
  const auto matches = [&](const std::vector<std::string>& list) {
    return std::any_of(list.begin(), list.end(),
                       [&](const std::string& name) { return names.count(name) > 0; });
  };
  return (filter_.include.empty() || matches(filter_.include)) && !matches(filter_.exclude);
}

void NameFilter::require_all_seen(const std::filesystem::path& file) const {
  const std::vector<std::string> known(seen_.begin(), seen_.end());
  for (const auto* names : {&filter_.include, &filter_.exclude}) {
    for (const std::string& name : *names) {
      if (seen_.count(name) > 0) continue;
      fail_input(fmt::format("no material, mesh or node is called '{}'", name), {file.string()},
                 suggest_name(name, known));
    }
  }
}

}  // namespace umbrameter

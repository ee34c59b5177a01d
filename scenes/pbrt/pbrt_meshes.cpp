// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/pbrt_meshes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

constexpr double kFlat = 1e-4;  // of the patch's own size

std::vector<Primitive::Vertex> vertices_of(const PbrtParameters& parameters, bool& has_normals,
                                           bool& has_uv) {
  const std::vector<glm::dvec3> positions = parameters.points("P"), normals = parameters.points("N");
  if (positions.empty()) fail_input("the mesh has no positions 'P'", parameters.where());
  const PbrtParameter* uv = parameters.find("uv") != nullptr ? parameters.find("uv") : parameters.find("st");
  has_normals = !normals.empty();
  has_uv = uv != nullptr;
  if (has_normals && normals.size() != positions.size())
    fail_input(fmt::format("the mesh has {} positions and {} normals", positions.size(), normals.size()),
               parameters.where());
  if (has_uv && uv->numbers.size() != 2 * positions.size())
    fail_input(fmt::format("the mesh has {} positions and {} texture coordinates", positions.size(),
                           uv->numbers.size()),
               uv->where);
  std::vector<Primitive::Vertex> vertices;
  for (size_t i = 0; i < positions.size(); ++i) {
    vertices.push_back({.p = positions[i]});
    if (has_normals) vertices.back().n = normals[i];
    if (has_uv) vertices.back().uv = {uv->numbers[2 * i], uv->numbers[2 * i + 1]};
  }
  return vertices;
}

/// `corners` of each face; without the list one face of that many vertices.
std::vector<uint32_t> indices_of(const PbrtParameters& parameters, size_t vertices, size_t corners) {
  const PbrtParameter* list = parameters.find("indices");
  std::vector<uint32_t> indices;
  if (list == nullptr) {
    if (vertices != corners) fail_input("the mesh has no 'indices'", parameters.where());
    for (uint32_t i = 0; i < corners; ++i) indices.push_back(i);
    return indices;
  }
  if (list->numbers.size() % corners != 0)
    fail_input(fmt::format("'indices' has {} numbers, no multiple of {}", list->numbers.size(), corners),
               list->where);
  for (const double index : list->numbers) {
    if (!(index >= 0.0 && index < static_cast<double>(vertices) && index == std::floor(index)))
      fail_input(fmt::format("'indices' holds {}, but there are {} vertices", index, vertices), list->where);
    indices.push_back(static_cast<uint32_t>(index));
  }
  return indices;
}

bool is_flat(const Primitive::Vertex* patch) {
  const glm::dvec3 u = patch[1].p - patch[0].p, v = patch[2].p - patch[0].p, far = patch[3].p - patch[0].p;
  const glm::dvec3 n = glm::cross(u, v);
  return std::abs(glm::dot(n, far)) <= kFlat * glm::length(n) * (glm::length(u) + glm::length(v));
}

}  // namespace

Primitive pbrt_triangles(const PbrtParameters& parameters) {
  Primitive mesh;
  bool has_uv = false;
  mesh.vertices = vertices_of(parameters, mesh.has_normals, has_uv);
  const std::vector<uint32_t> indices = indices_of(parameters, mesh.vertices.size(), 3);
  for (size_t i = 0; i < indices.size(); i += 3)
    mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
  return mesh;
}

Primitive pbrt_patches(const PbrtParameters& parameters, Tally& said) {
  Primitive mesh;
  bool has_uv = false;
  const std::vector<Primitive::Vertex> vertices = vertices_of(parameters, mesh.has_normals, has_uv);
  for (const uint32_t index : indices_of(parameters, vertices.size(), 4)) {
    const size_t corner = mesh.vertices.size() % 4;
    mesh.vertices.push_back(vertices[index]);
    if (!has_uv) mesh.vertices.back().uv = {corner % 2, corner / 2};
  }
  for (uint32_t first = 0; first < mesh.vertices.size(); first += 4) {
    if (!is_flat(&mesh.vertices[first]))
      said.add("bilinear patch that is not flat is two triangles",
               "bilinear patches that are not flat are two triangles");
    mesh.triangles.emplace_back(first, first + 1, first + 3);
    mesh.triangles.emplace_back(first, first + 3, first + 2);
  }
  return mesh;
}

}  // namespace umbrameter

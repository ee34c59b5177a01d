// SPDX-License-Identifier: Apache-2.0
#include "scenes/unroll.h"

#include "scenes/instances.h"
#include "scenes/merge_meshes.h"
#include "scenes/primitives.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

void append_solid_or_cut(const MeshData& copy, MeshData& mesh) {
  if (copy.cutouts.empty() && mesh.cutouts.empty()) return;
  mesh.cutout_of_triangle.resize(mesh.triangles.size(), kSolid);
  const auto first_cutout = static_cast<uint32_t>(mesh.cutouts.size());
  const auto first_mask = static_cast<uint32_t>(mesh.masks.size());
  for (size_t t = 0; t < copy.triangles.size(); ++t) {
    const uint32_t cutout = copy.cutouts.empty() ? kSolid : copy.cutout_of_triangle[t];
    mesh.cutout_of_triangle.push_back(cutout == kSolid ? kSolid : first_cutout + cutout);
  }
  for (const Cutout& cutout : copy.cutouts) mesh.cutouts.push_back({cutout.uv, first_mask + cutout.mask});
  mesh.masks.insert(mesh.masks.end(), copy.masks.begin(), copy.masks.end());
}

void append_copy(MeshData copy, MeshData& mesh) {
  if (mesh.normals.empty() != copy.normals.empty() && !mesh.triangles.empty())
    split_flat(mesh.normals.empty() ? mesh : copy);
  append_solid_or_cut(copy, mesh);
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  const auto first = static_cast<uint32_t>(mesh.triangles.size());
  // Parts cover all triangles, or there are none.
  if (mesh.parts.empty() && first > 0) mesh.parts.push_back({{}, 0, first});
  for (const MeshPart& part : copy.parts)
    mesh.parts.push_back({part.name, first + part.first_triangle, part.triangle_count});
  if (copy.parts.empty()) mesh.parts.push_back({{}, first, static_cast<uint32_t>(copy.triangles.size())});
  mesh.positions.insert(mesh.positions.end(), copy.positions.begin(), copy.positions.end());
  mesh.normals.insert(mesh.normals.end(), copy.normals.begin(), copy.normals.end());
  for (const glm::uvec3& t : copy.triangles) mesh.triangles.push_back(t + base);
}

MeshData placed(MeshData mesh, const glm::dmat4& world_from_mesh) {
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    Primitive::Vertex vertex{mesh.positions[v], mesh.normals.empty() ? glm::dvec3(0.0) : mesh.normals[v]};
    place(vertex, world_from_mesh);
    mesh.positions[v] = vertex.p;
    if (!mesh.normals.empty()) mesh.normals[v] = vertex.n == glm::dvec3(0.0) ? glm::dvec3(0, 1, 0) : vertex.n;
  }
  if (glm::determinant(glm::dmat3(world_from_mesh)) >= 0.0) return mesh;
  for (Cutout& cutout : mesh.cutouts) std::swap(cutout.uv[1], cutout.uv[2]);
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  return mesh;
}

}  // namespace

void unroll_squashed(MeshData& mesh) {
  for (RepeatedMesh& repeated : mesh.repeated) {
    std::vector<glm::dmat4>& places = repeated.world_from_mesh;
    const auto squashed = std::stable_partition(places.begin(), places.end(),
                                                [](const glm::dmat4& place) { return !squashes(place); });
    for (auto place = squashed; place != places.end(); ++place)
      append_copy(placed(repeated.mesh, *place), mesh);
    places.erase(squashed, places.end());
  }
  std::erase_if(mesh.repeated, [](const RepeatedMesh& one) { return one.world_from_mesh.empty(); });
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/merge_meshes.h"

#include "scenes/clean_triangles.h"
#include "scenes/read_values.h"
#include "scenes/unroll.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

using glm::dvec3;

glm::vec3 float_position(const dvec3& p, const NamedMesh& mesh) {
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (!(largest <= kMaxLength_world)) {  // catches NaN too
    fail_input(fmt::format("mesh '{}' has a vertex at ({}, {}, {}); coordinates must stay within {:g}",
                           mesh.name, p.x, p.y, p.z, kMaxLength_world),
               mesh.where, "check 'scale' and 'translate'");
  }
  return glm::vec3(p) + 0.0f;  // -0 becomes 0, so equal positions have equal bits
}

void append_parts(const NamedMesh& mesh, uint32_t first_triangle, Scene& scene) {
  if (mesh.mesh.parts.empty()) {
    scene.parts.push_back({mesh.name, first_triangle, static_cast<uint32_t>(mesh.mesh.triangles.size())});
    return;
  }
  for (const MeshPart& part : mesh.mesh.parts) {
    const std::string name = part.name.empty() ? mesh.name : mesh.name + "/" + part.name;
    scene.parts.push_back({name, first_triangle + part.first_triangle, part.triangle_count});
  }
}

/// `cutout_of_triangle` of the whole scene stays empty as long as everything is solid.
void append_cutouts(const MeshData& mesh, size_t first_triangle, std::vector<uint32_t>& cutout_of_triangle,
                    Scene& scene) {
  if (mesh.cutouts.empty() && cutout_of_triangle.empty()) return;
  cutout_of_triangle.resize(first_triangle, kSolid);
  const auto first_cutout = static_cast<uint32_t>(scene.cutouts.size());
  const auto first_mask = static_cast<uint32_t>(scene.masks.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const uint32_t cutout = mesh.cutouts.empty() ? kSolid : mesh.cutout_of_triangle[t];
    cutout_of_triangle.push_back(cutout == kSolid ? kSolid : first_cutout + cutout);
  }
  if (mesh.cutouts.empty()) return;
  std::vector<Cutout>& cutouts = scene.cutouts.edit();
  for (const Cutout& cutout : mesh.cutouts) cutouts.push_back({cutout.uv, first_mask + cutout.mask});
  std::vector<AlphaMask>& masks = scene.masks.edit();
  masks.insert(masks.end(), mesh.masks.begin(), mesh.masks.end());
}

/// Solid triangles first, then those with holes in the order of scene.cutouts; a part that has both becomes two.
void move_cutouts_last(Scene& scene, const std::vector<uint32_t>& cutout_of_triangle) {
  if (cutout_of_triangle.empty()) return;
  std::vector<glm::uvec3> triangles;
  std::vector<Cutout> cutouts;
  std::vector<MeshPart> parts;
  for (const bool wants_holes : {false, true}) {
    for (const MeshPart& part : scene.parts) {
      const auto first = static_cast<uint32_t>(triangles.size());
      for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
        if ((cutout_of_triangle[t] != kSolid) != wants_holes) continue;
        triangles.push_back(scene.triangles[t]);
        if (wants_holes) cutouts.push_back(scene.cutouts[cutout_of_triangle[t]]);
      }
      const auto count = static_cast<uint32_t>(triangles.size()) - first;
      if (count > 0) parts.push_back({part.name, first, count});
    }
  }
  scene.triangles = std::move(triangles);
  scene.cutouts = std::move(cutouts);
  scene.parts = std::move(parts);
}

void append(const NamedMesh& mesh, Scene& scene) {
  const size_t total = scene.triangles.size() + mesh.mesh.triangles.size();
  if (total > kMaxTriangles) {
    fail_input(fmt::format("with mesh '{}' the scene has {} triangles; at most {} can be told apart",
                           mesh.name, total, kMaxTriangles),
               mesh.where);
  }
  append_parts(mesh, static_cast<uint32_t>(scene.triangles.size()), scene);
  const auto base = static_cast<uint32_t>(scene.positions_world.size());
  std::vector<glm::vec3>& positions = scene.positions_world.edit();
  for (const dvec3& p : mesh.mesh.positions) positions.push_back(float_position(p, mesh));
  std::vector<glm::vec3>& normals = scene.normals_world.edit();
  for (const dvec3& n : mesh.mesh.normals) normals.emplace_back(n);
  std::vector<glm::uvec3>& triangles = scene.triangles.edit();
  for (const glm::uvec3& t : mesh.mesh.triangles) triangles.push_back(t + base);
}

bool has_normals(const MeshData& mesh) {
  return !mesh.normals.empty() || std::ranges::any_of(mesh.repeated, [](const RepeatedMesh& repeated) {
    return !repeated.mesh.normals.empty();
  });
}

std::string describe_loss(size_t zero_area, size_t duplicates) {
  std::string text;
  if (zero_area > 0) text = fmt::format("{} triangle{} of zero area", zero_area, zero_area == 1 ? "" : "s");
  if (duplicates == 0) return text;
  return text +
         fmt::format("{}{} duplicate{}", text.empty() ? "" : ", ", duplicates, duplicates == 1 ? "" : "s");
}

/// Counts what each mesh loses; `first_triangles[i]` is where mesh i starts, with the total at the end.
void report_faults(const std::vector<NamedMesh>& meshes, const std::vector<uint32_t>& first_triangles,
                   const std::vector<TriangleFault>& faults, Scene& scene) {
  for (size_t i = 0; i < meshes.size(); ++i) {
    const auto begin = faults.begin() + first_triangles[i];
    const auto end = faults.begin() + first_triangles[i + 1];
    const auto zero_area = static_cast<size_t>(std::count(begin, end, TriangleFault::zero_area));
    const auto duplicates = static_cast<size_t>(std::count(begin, end, TriangleFault::duplicate));
    if (zero_area + duplicates == 0) continue;
    const std::string loss = describe_loss(zero_area, duplicates);
    const bool is_all = static_cast<size_t>(end - begin) == zero_area + duplicates;
    if (is_all && duplicates == 0)
      fail_input(fmt::format("mesh '{}' is empty: {} had to be dropped", meshes[i].name, loss),
                 meshes[i].where);
    // What stands where another mesh does is shown all the same.
    scene.warnings.push_back(
        fmt::format("{}: dropped {}{}", meshes[i].label, loss, is_all ? "; nothing of it is left" : ""));
  }
}

}  // namespace

void split_flat(MeshData& mesh) {
  std::vector<dvec3> positions;
  for (glm::uvec3& t : mesh.triangles) {
    const dvec3 corners[3] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(normal);
    const auto first = static_cast<uint32_t>(positions.size());
    positions.insert(positions.end(), corners, corners + 3);
    // A triangle without area is dropped later; any unit vector will do.
    mesh.normals.insert(mesh.normals.end(), 3, length > 0.0 ? normal / length : dvec3(0, 1, 0));
    t = {first, first + 1, first + 2};
  }
  mesh.positions = std::move(positions);
}

void merge_meshes(std::vector<NamedMesh>& meshes, Scene& scene) {
  for (NamedMesh& mesh : meshes) unroll_squashed(mesh.mesh);
  const bool smooth =
      std::any_of(meshes.begin(), meshes.end(), [](const NamedMesh& mesh) { return has_normals(mesh.mesh); });
  std::vector<uint32_t> first_triangles{0};
  std::vector<uint32_t> cutout_of_triangle;
  for (NamedMesh& mesh : meshes) {
    if (smooth && mesh.mesh.normals.empty()) split_flat(mesh.mesh);
    append_cutouts(mesh.mesh, scene.triangles.size(), cutout_of_triangle, scene);
    append(mesh, scene);
    scene.side_files.insert(scene.side_files.end(), mesh.mesh.side_files.begin(), mesh.mesh.side_files.end());
    first_triangles.push_back(static_cast<uint32_t>(scene.triangles.size()));
    std::vector<RepeatedMesh> repeated = std::move(mesh.mesh.repeated);
    mesh.mesh = {};
    mesh.mesh.repeated = std::move(repeated);
  }
  const std::vector<TriangleFault> faults = find_triangle_faults(scene);
  report_faults(meshes, first_triangles, faults, scene);
  remove_triangles(scene, faults);
  size_t next = 0;
  for (size_t t = 0; t < cutout_of_triangle.size(); ++t) {
    if (faults[t] == TriangleFault::none) cutout_of_triangle[next++] = cutout_of_triangle[t];
  }
  if (!cutout_of_triangle.empty()) cutout_of_triangle.resize(next);
  move_cutouts_last(scene, cutout_of_triangle);
  for (const glm::vec3& p : scene.positions_world) {
    scene.bounds_world.min = glm::min(scene.bounds_world.min, dvec3(p));
    scene.bounds_world.max = glm::max(scene.bounds_world.max, dvec3(p));
  }
  for (NamedMesh& mesh : meshes) add_instances(mesh, smooth, scene);
}

}  // namespace umbrameter

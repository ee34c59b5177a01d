// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/scene_buffers.h"

#include <numeric>

namespace umbrameter {

namespace {

constexpr float kNoNormal = 0.0f;

VertexArray make_indexed_vertex_array(const Buffer& positions, const Buffer& triangles) {
  VertexArray array = make_empty_vertex_array();
  glEnableVertexArrayAttrib(array.id(), 0);
  glVertexArrayAttribFormat(array.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(array.id(), 0, 0);
  glVertexArrayVertexBuffer(array.id(), 0, positions.id(), 0, sizeof(glm::vec3));
  glVertexArrayElementBuffer(array.id(), triangles.id());
  return array;
}

/// `own`, then what `of_mesh` gives for each mesh.
template <class T, class OfMesh>
Buffer joined(const SharedList<T>& own, const Scene& scene, const OfMesh& of_mesh) {
  if (scene.instanced.empty()) return Buffer::of(std::span(own));
  std::vector<T> all(own.begin(), own.end());
  for (const auto& mesh : scene.instanced) {
    const SharedList<T>& more = of_mesh(*mesh);
    all.insert(all.end(), more.begin(), more.end());
  }
  return Buffer::of(std::span<const T>(all));
}

Buffer joined_positions(const Scene& scene) {
  return joined(
      scene.positions_world, scene, [](const InstancedMesh& mesh) -> auto& { return mesh.positions; });
}

Buffer joined_normals(const Scene& scene) {
  if (!has_shading_normals(scene)) return Buffer(sizeof(float), &kNoNormal);
  return joined(
      scene.normals_world, scene, [](const InstancedMesh& mesh) -> auto& { return mesh.normals; });
}

Buffer joined_triangles(const Scene& scene) {
  auto first_vertex = static_cast<uint32_t>(scene.positions_world.size());
  SharedList<glm::uvec3> shifted;
  return joined(
      scene.triangles, scene, [&](const InstancedMesh& mesh) -> auto& {
        std::vector<glm::uvec3> triangles(mesh.triangles.begin(), mesh.triangles.end());
        for (glm::uvec3& t : triangles) t += first_vertex;
        first_vertex += static_cast<uint32_t>(mesh.positions.size());
        shifted = std::move(triangles);
        return shifted;
      });
}

}  // namespace

IndexRanges::IndexRanges(std::span<const TriangleRange> triangles) {
  for (const TriangleRange& range : triangles) {
    counts.push_back(static_cast<GLsizei>(3 * range.count));
    offsets.push_back(reinterpret_cast<const void*>(sizeof(glm::uvec3) * uintptr_t{range.first}));
  }
}

size_t IndexRanges::triangle_count() const {
  return std::accumulate(counts.begin(), counts.end(), size_t{0},
                         [](size_t sum, GLsizei count) { return sum + static_cast<size_t>(count) / 3; });
}

SceneBuffers::SceneBuffers(const Scene& scene)
    : positions_(joined_positions(scene)),
      triangles_(joined_triangles(scene)),
      normals_(joined_normals(scene)),
      cutouts_(count_shown_cutouts(scene) == 0 ? nullptr : std::make_unique<const CutoutBuffers>(scene)),
      instances_(scene.instanced.empty() ? nullptr
                                         : std::make_unique<const InstanceBuffers>(
                                               scene, positions_, triangles_, cutouts_.get())),
      indexed_(make_indexed_vertex_array(positions_, triangles_)),
      pulled_(make_empty_vertex_array()),
      own_count_(scene.triangles.size()),
      solid_count_(scene.first_cutout()),
      shown_count_(count_shown_triangles(scene)),
      has_normals_(has_shading_normals(scene)) {}

void SceneBuffers::draw() const {
  glBindVertexArray(indexed_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * solid_count_), GL_UNSIGNED_INT, nullptr);
}

void SceneBuffers::draw(const IndexRanges& ranges) const {
  glBindVertexArray(indexed_.id());
  glMultiDrawElements(GL_TRIANGLES, ranges.counts.data(), GL_UNSIGNED_INT, ranges.offsets.data(),
                      static_cast<GLsizei>(ranges.counts.size()));
}

void SceneBuffers::draw_pulled(int vertices_per_triangle) const {
  glBindVertexArray(pulled_.id());
  glDrawArrays(GL_TRIANGLES, 0,
               static_cast<GLsizei>(static_cast<size_t>(vertices_per_triangle) * own_count_));
}

void SceneBuffers::bind_storage() const {
  bind_storage_buffer(kPositionsBinding, positions_);
  bind_storage_buffer(kTrianglesBinding, triangles_);
  bind_storage_buffer(kNormalsBinding, normals_);
  if (cutouts_) cutouts_->bind_storage();
  if (instances_) instances_->bind_storage();
}

size_t SceneBuffers::bytes() const {
  return positions_.bytes() + triangles_.bytes() + normals_.bytes() + (cutouts_ ? cutouts_->bytes() : 0) +
         (instances_ ? instances_->bytes() : 0);
}

}  // namespace umbrameter

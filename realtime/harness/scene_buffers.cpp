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
    : positions_(Buffer::of(std::span(scene.positions_world))),
      triangles_(Buffer::of(std::span(scene.triangles))),
      normals_(scene.normals_world.empty() ? Buffer(sizeof(float), &kNoNormal)
                                           : Buffer::of(std::span(scene.normals_world))),
      cutouts_(scene.cutouts.empty() ? nullptr : std::make_unique<const CutoutBuffers>(scene)),
      indexed_(make_indexed_vertex_array(positions_, triangles_)),
      pulled_(make_empty_vertex_array()),
      triangle_count_(scene.triangles.size()),
      solid_count_(scene.first_cutout()),
      has_normals_(!scene.normals_world.empty()) {}

void SceneBuffers::draw() const {
  glBindVertexArray(indexed_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * solid_count_), GL_UNSIGNED_INT, nullptr);
}

void SceneBuffers::draw(const IndexRanges& ranges) const {
  glBindVertexArray(indexed_.id());
  glMultiDrawElements(GL_TRIANGLES, ranges.counts.data(), GL_UNSIGNED_INT, ranges.offsets.data(),
                      static_cast<GLsizei>(ranges.counts.size()));
}

void SceneBuffers::draw_pulled() const {
  glBindVertexArray(pulled_.id());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * triangle_count_));
}

void SceneBuffers::bind_storage() const {
  bind_storage_buffer(kPositionsBinding, positions_);
  bind_storage_buffer(kTrianglesBinding, triangles_);
  bind_storage_buffer(kNormalsBinding, normals_);
  if (cutouts_) cutouts_->bind_storage();
}

size_t SceneBuffers::bytes() const {
  return positions_.bytes() + triangles_.bytes() + normals_.bytes() + (cutouts_ ? cutouts_->bytes() : 0);
}

}  // namespace umbrameter

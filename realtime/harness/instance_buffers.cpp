// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/instance_buffers.h"

#include "realtime/harness/cutout_buffers.h"

#include <algorithm>

namespace umbrameter {
namespace {

constexpr GLuint kNumbersSlot = 1;  // of vertex buffers

/// lib/instances.glsl InstanceRecord.
struct InstanceRecord {
  glm::vec4 rows[3];
  uint32_t first_shown;
  uint32_t first_triangle;
  uint32_t first_cutout;
  uint32_t first_record;
};

void set_rows(const glm::mat4x3& world_from_mesh, InstanceRecord& record) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) record.rows[row][column] = world_from_mesh[column][row];
  }
}

void add_numbers(const VertexArray& array) {
  glEnableVertexArrayAttrib(array.id(), kInstanceLocation);
  glVertexArrayAttribIFormat(array.id(), kInstanceLocation, 1, GL_UNSIGNED_INT, 0);
  glVertexArrayAttribBinding(array.id(), kInstanceLocation, kNumbersSlot);
  glVertexArrayBindingDivisor(array.id(), kNumbersSlot, 1);
}

VertexArray solid_array(const Buffer& positions, const Buffer& triangles) {
  VertexArray array = make_empty_vertex_array();
  glEnableVertexArrayAttrib(array.id(), 0);
  glVertexArrayAttribFormat(array.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(array.id(), 0, 0);
  glVertexArrayVertexBuffer(array.id(), 0, positions.id(), 0, sizeof(glm::vec3));
  glVertexArrayElementBuffer(array.id(), triangles.id());
  add_numbers(array);
  return array;
}

VertexArray cutout_array(const CutoutBuffers* cutouts) {
  VertexArray array =
      cutouts == nullptr ? make_empty_vertex_array() : make_cutout_vertex_array(cutouts->vertices());
  add_numbers(array);
  return array;
}

VertexArray number_array() {
  VertexArray array = make_empty_vertex_array();
  add_numbers(array);
  return array;
}

void bind_selection(const VertexArray& array, const InstanceSelection& selection) {
  glVertexArrayVertexBuffer(array.id(), kNumbersSlot, selection.numbers.id(), 0, sizeof(uint32_t));
  glBindVertexArray(array.id());
}

}  // namespace

InstanceBuffers::InstanceBuffers(const Scene& scene, const Buffer& positions, const Buffer& triangles,
                                 const CutoutBuffers* cutouts)
    : solid_(solid_array(positions, triangles)), cutouts_(cutout_array(cutouts)), pulled_(number_array()) {
  auto next_triangle = static_cast<uint32_t>(scene.triangles.size());
  auto next_cutout = static_cast<uint32_t>(scene.cutouts.size());
  uint32_t next_shown = next_triangle, next_instance = 0;
  std::vector<InstanceRecord> records;
  for (const auto& mesh : scene.instanced) {
    const auto count = static_cast<uint32_t>(mesh->triangles.size());
    const auto instances = static_cast<uint32_t>(mesh->world_from_mesh.size());
    for (const glm::mat4x3& place : mesh->world_from_mesh) {
      InstanceRecord& record = records.emplace_back(
          InstanceRecord{{}, next_shown, next_triangle, mesh->first_cutout(), cutout_word(next_cutout)});
      set_rows(place, record);
      next_shown += count;
    }
    meshes_.push_back({next_triangle, static_cast<GLsizei>(count), static_cast<GLsizei>(mesh->first_cutout()),
                       static_cast<GLint>(3 * next_cutout), next_instance, instances});
    next_triangle += count;
    next_cutout += static_cast<uint32_t>(mesh->cutouts.size());
    next_instance += instances;
    has_holes_ = has_holes_ || !mesh->cutouts.empty();
  }
  records_ = Buffer::of(std::span<const InstanceRecord>(records));
  std::vector<uint32_t> numbers(records.size());
  for (uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
  all_ = select(numbers);
}

InstanceSelection InstanceBuffers::select(std::span<const uint32_t> numbers) const {
  InstanceSelection selection;
  if (!numbers.empty()) selection.numbers = Buffer::of(numbers);
  for (const Mesh& mesh : meshes_) {
    const auto begin = std::ranges::lower_bound(numbers, mesh.first_instance);
    const auto end = std::ranges::lower_bound(numbers, mesh.first_instance + mesh.instances);
    selection.runs.push_back(
        {static_cast<GLuint>(begin - numbers.begin()), static_cast<GLsizei>(end - begin)});
    selection.triangles += static_cast<uint64_t>(end - begin) * static_cast<uint64_t>(mesh.triangles);
  }
  return selection;
}

void InstanceBuffers::bind_storage() const {
  bind_storage_buffer(kInstancesBinding, records_);
}

void InstanceBuffers::draw(const InstanceSelection& selection) const {
  bind_storage();
  bind_selection(solid_, selection);
  for (size_t i = 0; i < meshes_.size(); ++i) {
    const Mesh& mesh = meshes_[i];
    const InstanceSelection::Run& run = selection.runs[i];
    if (run.count == 0 || mesh.solid == 0) continue;
    const auto* first = reinterpret_cast<const void*>(sizeof(glm::uvec3) * uintptr_t{mesh.first_triangle});
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, 3 * mesh.solid, GL_UNSIGNED_INT, first, run.count,
                                        run.first);
  }
}

void InstanceBuffers::draw_cutouts(const InstanceSelection& selection) const {
  bind_storage();
  bind_selection(cutouts_, selection);
  for (size_t i = 0; i < meshes_.size(); ++i) {
    const Mesh& mesh = meshes_[i];
    const InstanceSelection::Run& run = selection.runs[i];
    if (run.count == 0 || mesh.solid == mesh.triangles) continue;
    glDrawArraysInstancedBaseInstance(GL_TRIANGLES, mesh.first_cutout_vertex,
                                      3 * (mesh.triangles - mesh.solid), run.count, run.first);
  }
}

void InstanceBuffers::draw_pulled(const InstanceSelection& selection, int vertices_per_triangle) const {
  bind_storage();
  bind_selection(pulled_, selection);
  for (size_t i = 0; i < meshes_.size(); ++i) {
    const InstanceSelection::Run& run = selection.runs[i];
    if (run.count > 0)
      glDrawArraysInstancedBaseInstance(GL_TRIANGLES, 0, vertices_per_triangle * meshes_[i].triangles,
                                        run.count, run.first);
  }
}

size_t InstanceBuffers::bytes() const {
  return records_.bytes() + all_.numbers.bytes();
}

}  // namespace umbrameter

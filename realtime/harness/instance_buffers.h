// SPDX-License-Identifier: Apache-2.0
#pragma once
// Instances on the GPU: a record each, and draws of each mesh as often as it stands somewhere.

#include "realtime/harness/objects.h"
#include "scenes/instances.h"

#include <span>
#include <vector>

namespace umbrameter {

class CutoutBuffers;

/// Storage binding of lib/instances.glsl: 16 words an instance, in the order of list_instances().
inline constexpr GLuint kInstancesBinding = 4;
inline constexpr size_t kInstanceBytes = 68;  // its record and its number
/// Attribute location of an instance's number.
inline constexpr GLuint kInstanceLocation = 3;

/// Some of a scene's instances, ready to be drawn.
struct InstanceSelection {
  struct Run {
    GLuint first = 0;  // in `numbers`
    GLsizei count = 0;
  };
  Buffer numbers;         // of instances, ascending
  std::vector<Run> runs;  // one a mesh
  uint64_t triangles = 0;
};

/// For scenes with instances only.
class InstanceBuffers {
 public:
  /// `positions` and `triangles`: of SceneBuffers, which hold the meshes behind the scene's own. `cutouts` does, too; null
  /// where nothing has holes.
  InstanceBuffers(const Scene& scene, const Buffer& positions, const Buffer& triangles,
                  const CutoutBuffers* cutouts);

  InstanceSelection select(std::span<const uint32_t> numbers) const;
  const InstanceSelection& all() const { return all_; }
  bool has_holes() const { return has_holes_; }

  void bind_storage() const;
  /// Every solid triangle: locations 0 = vec3 in the mesh's space, kInstanceLocation. A program with instance_vertex_prelude()
  /// (placed_vertices.h) must be in use.
  void draw(const InstanceSelection& selection) const;
  /// Every triangle with holes, as CutoutBuffers::draw(); also needs its preludes.
  void draw_cutouts(const InstanceSelection& selection) const;
  /// So many vertices a triangle that pull from the storage buffers, with kInstanceLocation.
  void draw_pulled(const InstanceSelection& selection, int vertices_per_triangle = 3) const;
  size_t bytes() const;

 private:
  struct Mesh {
    uint32_t first_triangle = 0;  // in the index buffer
    GLsizei triangles = 0, solid = 0;
    GLint first_cutout_vertex = 0;
    uint32_t first_instance = 0, instances = 0;
  };

  std::vector<Mesh> meshes_;
  Buffer records_;
  VertexArray solid_, cutouts_, pulled_;
  InstanceSelection all_;
  bool has_holes_ = false;
};

}  // namespace umbrameter

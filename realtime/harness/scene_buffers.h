// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's triangles on the GPU, uploaded once.

#include "realtime/harness/cutout_buffers.h"
#include "realtime/harness/instance_buffers.h"
#include "realtime/harness/objects.h"
#include "realtime/views/casters.h"
#include "scenes/scene.h"

#include <memory>
#include <vector>

namespace umbrameter {

/// Storage bindings of the triangle data, for shaders that look vertices up by gl_PrimitiveID or gl_VertexID.
inline constexpr GLuint kPositionsBinding = 0;  // float[3 * vertex]
inline constexpr GLuint kTrianglesBinding = 1;  // uint[3 * triangle]
inline constexpr GLuint kNormalsBinding = 2;    // float[3 * vertex], or 1 unused float without normals

/// Ranges of triangles as glMultiDrawElements takes them.
struct IndexRanges {
  std::vector<GLsizei> counts;       // of indices
  std::vector<const void*> offsets;  // bytes into the index buffer

  explicit IndexRanges(std::span<const TriangleRange> triangles);
  size_t triangle_count() const;
};

/// The scene's own vertices and triangles come first in every buffer, then mesh by mesh those that stand in several places,
/// in their own space.
class SceneBuffers {
 public:
  explicit SceneBuffers(const Scene& scene);

  /// One indexed draw of every solid triangle of the scene's own; attribute location 0 = vec3 p_world. A program must be in use.
  void draw() const;
  /// The same of these triangles alone, in one call; gl_PrimitiveID starts anew in each range.
  void draw(const IndexRanges& ranges) const;
  /// One draw of so many vertices for each triangle of the scene's own, without attributes, for shaders that pull from the
  /// storage buffers.
  void draw_pulled(int vertices_per_triangle = 3) const;
  /// Null for a scene without.
  const InstanceBuffers* instances() const { return instances_.get(); }
  /// The triangles with holes; null for a scene without.
  const CutoutBuffers* cutouts() const { return cutouts_.get(); }
  /// As the bindings above say.
  const Buffer& positions() const { return positions_; }
  const Buffer& triangles() const { return triangles_; }
  const Buffer& normals() const { return normals_; }
  /// Binds the storage buffers.
  void bind_storage() const;

  /// Shown ones (scenes/instances.h).
  uint64_t triangle_count() const { return shown_count_; }
  bool has_normals() const { return has_normals_; }
  size_t bytes() const;

 private:
  Buffer positions_;
  Buffer triangles_;
  Buffer normals_;
  std::unique_ptr<const CutoutBuffers> cutouts_;
  std::unique_ptr<const InstanceBuffers> instances_;
  VertexArray indexed_;
  VertexArray pulled_;
  size_t own_count_ = 0;
  size_t solid_count_ = 0;
  uint64_t shown_count_ = 0;
  bool has_normals_ = false;
};

}  // namespace umbrameter

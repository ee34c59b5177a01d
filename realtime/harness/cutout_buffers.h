// SPDX-License-Identifier: Apache-2.0
#pragma once
// Triangles with holes on the GPU, and what makes any pass's shaders respect the holes.

#include "realtime/harness/objects.h"
#include "scenes/scene.h"

#include <string>

namespace umbrameter {

/// Storage binding of lib/cutout.glsl: word 0 = the first triangle with holes; then 7 words a triangle, u and v of its
/// corners as floats and where its mask starts; then the masks, each width, height and its bits.
inline constexpr GLuint kCutoutsBinding = 3;
/// The word at which the record of cutout `cutout` begins: the scene's own come first, then mesh by mesh those of
/// scene.instanced.
uint32_t cutout_word(uint32_t cutout);

/// For scenes with cutouts only.
class CutoutBuffers {
 public:
  explicit CutoutBuffers(const Scene& scene);

  void bind_storage() const;
  /// Every triangle of the scene's own with holes: attribute location 0 = vec3 p_world as for the others, 1 and 2 as cutout_vertex_prelude()
  /// declares them. A program with both preludes must be in use.
  void draw() const;
  /// Three a cutout, in the order of their records; those of meshes in the mesh's space.
  const Buffer& vertices() const { return vertices_; }
  size_t bytes() const { return words_.bytes() + vertices_.bytes(); }

 private:
  Buffer words_;
  Buffer vertices_;
  VertexArray array_;
  GLsizei vertex_count_ = 0;
};

/// Of CutoutBuffers::vertices(), by buffer slot 0.
VertexArray make_cutout_vertex_array(const Buffer& vertices);

/// Put at the end of a pass's own preludes: its main() runs first (after `before_main`), then what lies in a
/// hole is discarded.
std::string cutout_vertex_prelude(const std::string& before_main = {});
std::string cutout_fragment_prelude();

}  // namespace umbrameter

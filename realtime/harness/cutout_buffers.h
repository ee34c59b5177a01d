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

/// For scenes with cutouts only.
class CutoutBuffers {
 public:
  explicit CutoutBuffers(const Scene& scene);

  void bind_storage() const;
  /// Every triangle with holes: attribute location 0 = vec3 p_world as for the others, 1 and 2 as cutout_vertex_prelude()
  /// declares them. A program with both preludes must be in use.
  void draw() const;
  size_t bytes() const { return words_.bytes() + vertices_.bytes(); }

 private:
  Buffer words_;
  Buffer vertices_;
  VertexArray array_;
  GLsizei vertex_count_ = 0;
};

/// Put at the end of a pass's own preludes: its main() runs first, then what lies in a hole is discarded.
std::string cutout_vertex_prelude();
std::string cutout_fragment_prelude();

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's data on the GPU that only some techniques read.

#include "realtime/graph/scene_read.h"
#include "realtime/harness/scene_buffers.h"

#include <cstdint>
#include <optional>

namespace umbrameter {

class SceneData {
 public:
  /// `buffers` is of the same scene and outlives this; `made` counts the buffers that get() makes.
  SceneData(const SceneBuffers& buffers, uint64_t& made) : buffers_(buffers), made_(made) {}

  /// Made when first asked for. `scene` is the one of the buffers.
  const Buffer& get(SceneRead read, const Scene& scene);

 private:
  const Buffer& make(std::optional<Buffer>& kept, Buffer (*from)(const Scene&), const Scene& scene);

  const SceneBuffers& buffers_;
  uint64_t& made_;
  std::optional<Buffer> adjacency_, bvh_;
};

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/scene_data/scene_data.h"

#include "core/error.h"
#include "realtime/scene_data/adjacency.h"
#include "realtime/scene_data/bvh.h"

namespace umbrameter {
namespace {

Buffer adjacency_buffer(const Scene& scene) {
  const std::vector<uint32_t> neighbours = triangle_neighbours(scene);
  return Buffer::of(std::span<const uint32_t>(neighbours));
}

Buffer bvh_buffer(const Scene& scene) {
  const std::vector<glm::uvec4> rows = make_bvh(scene);
  return Buffer::of(std::span<const glm::uvec4>(rows));
}

}  // namespace

const Buffer& SceneData::make(std::optional<Buffer>& kept, Buffer (*from)(const Scene&), const Scene& scene) {
  if (kept) return *kept;
  ++made_;
  return kept.emplace(from(scene));
}

const Buffer& SceneData::get(SceneRead read, const Scene& scene) {
  switch (read) {
    case SceneRead::positions:
      return buffers_.positions();
    case SceneRead::triangles:
      return buffers_.triangles();
    case SceneRead::normals:
      return buffers_.normals();
    case SceneRead::adjacency:
      return make(adjacency_, adjacency_buffer, scene);
    case SceneRead::bvh:
      return make(bvh_, bvh_buffer, scene);
  }
  UMBRAMETER_ASSERT(false, "{}", "no such data of a scene");
  return buffers_.positions();
}

}  // namespace umbrameter

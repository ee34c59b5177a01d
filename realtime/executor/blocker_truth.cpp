// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/blocker_truth.h"

#include "core/blocker_planes.h"
#include "core/error.h"

#include <algorithm>

namespace umbrameter {
namespace {

void require_truth_of(const Image& truth, int width_px, int height_px) {
  if (truth.width != width_px || truth.height != height_px)
    fail_input(fmt::format("the truth is {} x {} px, the picture {} x {}", truth.width, truth.height,
                           width_px, height_px));
  for (const char* plane : kBlockerOffsetPlanes) {
    if (!truth.has(plane)) fail_input(fmt::format("the truth has no plane '{}'", plane));
  }
}

}  // namespace

Texture upload_blocker_truth(const Image& truth, int width_px, int height_px) {
  require_truth_of(truth, width_px, height_px);
  const auto width = static_cast<size_t>(width_px), height = static_cast<size_t>(height_px);
  const size_t components = kBlockerOffsetPlanes.size() + 1;
  std::vector<float> texels(width * height * components);
  for (size_t k = 0; k < kBlockerOffsetPlanes.size(); ++k) {
    const std::span<const float> plane = truth.plane(kBlockerOffsetPlanes[k]);
    for (size_t i = 0; i < plane.size(); ++i) {
      const size_t row = height - 1 - i / width;
      texels[(row * width + i % width) * components + k] = plane[i];
    }
  }
  Texture texture(find_texture_format("rgba32f"), width_px, height_px, "blocker_truth");
  glTextureSubImage2D(texture.id(), 0, 0, 0, width_px, height_px, GL_RGBA, GL_FLOAT, texels.data());
  return texture;
}

void require_blocker_search(const Plan& plan, const std::string& technique) {
  const bool reads_truth = std::ranges::any_of(plan.passes, [](const PreparedPass& pass) {
    if (!pass.program) return false;
    const std::vector<std::string> names = active_uniforms(*pass.program);
    return std::ranges::find(names, "blocker_truth") != names.end();
  });
  if (!reads_truth)
    fail_input(fmt::format("technique '{}' does not look for the distance of blockers", technique));
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "lab/causes/blocker_extension.h"

#include "core/blocker_planes.h"
#include "metrics/image/nearest_feature.h"

namespace umbrameter {

Image extended_blockers(const Image& truth) {
  std::vector<uint8_t> is_blocked(truth.pixel_count(), 0);
  for (const char* channel : kBlockerOffsetPlanes) {
    const auto offset = truth.plane(channel);
    for (size_t i = 0; i < offset.size(); ++i) is_blocked[i] |= offset[i] != 0.0f ? 1 : 0;
  }
  const std::vector<int32_t> nearest = nearest_feature(is_blocked, truth.width, truth.height);
  Image extended(truth.width, truth.height);
  for (const char* channel : kBlockerOffsetPlanes) {
    const auto from = truth.plane(channel);
    const auto to = extended.add_plane(channel);
    for (size_t i = 0; i < to.size(); ++i)
      to[i] = nearest[i] < 0 ? 0.0f : from[static_cast<size_t>(nearest[i])];
  }
  return extended;
}

}  // namespace umbrameter

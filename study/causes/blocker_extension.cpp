// SPDX-License-Identifier: Apache-2.0
#include "study/causes/blocker_extension.h"

#include "metrics/nearest_feature.h"

#include <array>

namespace umbrameter {
namespace {

constexpr std::array kOffsets = {"blocker_offset.x", "blocker_offset.y", "blocker_offset.z"};

}  // namespace

Image extended_blockers(const Image& truth) {
  std::vector<uint8_t> is_blocked(truth.pixel_count(), 0);
  for (const char* channel : kOffsets) {
    const auto offset = truth.plane(channel);
    for (size_t i = 0; i < offset.size(); ++i) is_blocked[i] |= offset[i] != 0.0f ? 1 : 0;
  }
  const std::vector<int32_t> nearest = nearest_feature(is_blocked, truth.width, truth.height);
  Image extended(truth.width, truth.height);
  for (const char* channel : kOffsets) {
    const auto from = truth.plane(channel);
    const auto to = extended.add_plane(channel);
    for (size_t i = 0; i < to.size(); ++i)
      to[i] = nearest[i] < 0 ? 0.0f : from[static_cast<size_t>(nearest[i])];
  }
  return extended;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/checks.h"

#include "core/error.h"
#include "metrics/image/tiles.h"

#include <limits>

namespace umbrameter {

namespace {

constexpr size_t kNoColumn = std::numeric_limits<size_t>::max();

int is_bad(uint8_t mask, float value, float low, float high) {
  return static_cast<int>(mask != 0) &
         (1 - (static_cast<int>(value >= low) & static_cast<int>(value <= high)));
}

}  // namespace

void require_mask_size(const Image& image, std::span<const uint8_t> mask, std::string_view what) {
  if (mask.size() == image.pixel_count()) return;
  fail_input(fmt::format("{}: the mask has {} pixels, the {}x{} image {}", what, mask.size(), image.width,
                         image.height, image.pixel_count()));
}

void require_range(const Image& image, std::string_view channel, std::span<const uint8_t> mask, float low,
                   float high) {
  const std::span<const float> values = image.plane(channel);
  const size_t width = static_cast<size_t>(image.width);
  std::vector<size_t> first_bad(static_cast<size_t>(image.height), kNoColumn);
  for_each_row(image.height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * width;
    // Without a branch a pixel, so that it vectorises; the search is for the rare row that needs it.
    int bad = 0;
    for (size_t i = begin; i < begin + width; ++i) bad |= is_bad(mask[i], values[i], low, high);
    if (bad == 0) return;
    size_t i = begin;
    while (is_bad(mask[i], values[i], low, high) == 0) ++i;
    first_bad[static_cast<size_t>(y)] = i;
  });
  for (const size_t i : first_bad) {
    if (i == kNoColumn) continue;
    fail_input(fmt::format("channel '{}' is {} at pixel ({}, {}), outside [{}, {}]", channel, values[i],
                           i % width, i / width, low, high));
  }
}

void require_visibility(const Image& image, std::string_view channel, std::span<const uint8_t> mask) {
  require_range(image, channel, mask, -kVisibilityRounding, 1.0f + kVisibilityRounding);
}

}  // namespace umbrameter

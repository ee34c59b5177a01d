// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/check_visibility.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

std::optional<std::string> check_visibility(const Image& image, std::string_view technique) {
  const std::span<const float> visibility = image.plane("visibility");
  const auto width = static_cast<size_t>(image.width);
  size_t outside = 0;
  size_t worst = 0;
  float worst_excess = kVisibilityTolerance;
  for (size_t pixel = 0; pixel < visibility.size(); ++pixel) {
    const float value = visibility[pixel];
    if (!std::isfinite(value)) {
      fail_input(fmt::format("technique '{}' gives visibility {} at pixel ({}, {})", technique, value,
                             pixel % width, pixel / width),
                 {}, "row 0 is on top; every pixel must be written, background too");
    }
    const float excess = std::max(-value, value - 1.0f);
    if (excess <= kVisibilityTolerance) continue;
    ++outside;
    if (excess > worst_excess) {
      worst_excess = excess;
      worst = pixel;
    }
  }
  if (outside == 0) return std::nullopt;
  return fmt::format("technique '{}' gives {} pixels a visibility outside [0,1], worst {} at ({}, {})",
                     technique, outside, visibility[worst], worst % width, worst / width);
}

}  // namespace umbrameter

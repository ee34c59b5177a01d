// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/disc_extreme.h"

#include <bit>
#include <cmath>
#include <limits>

namespace umbrameter {

DiscMinimum::DiscMinimum(std::span<const float> plane, std::span<const uint8_t> mask, const TileGrid& image,
                         const Tile& tile, double max_radius_px, float sign) {
  const int reach = static_cast<int>(max_radius_px);
  region_ = {std::max(0, tile.x0 - reach), std::max(0, tile.y0 - reach),
             std::min(image.width, tile.x1 + reach), std::min(image.height, tile.y1 + reach)};
  const size_t columns = static_cast<size_t>(region_.x1 - region_.x0);
  const size_t rows = static_cast<size_t>(region_.y1 - region_.y0);

  levels_.emplace_back(columns * rows, std::numeric_limits<float>::infinity());
  for (int y = region_.y0; y < region_.y1; ++y) {
    for (int x = region_.x0; x < region_.x1; ++x) {
      const size_t from = static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x);
      if (mask[from] == 0) continue;
      levels_[0][static_cast<size_t>(y - region_.y0) * columns + static_cast<size_t>(x - region_.x0)] =
          sign * plane[from];
    }
  }
  const size_t longest = std::min(columns, static_cast<size_t>(2 * reach + 1));
  for (size_t run = 1; 2 * run <= longest; run *= 2) {
    const std::vector<float>& half = levels_.back();
    std::vector<float> whole = half;
    for (size_t row = 0; row < rows; ++row) {
      const size_t begin = row * columns;
      for (size_t i = begin; i + run < begin + columns; ++i) whole[i] = std::min(half[i], half[i + run]);
    }
    levels_.push_back(std::move(whole));
  }
}

float DiscMinimum::run_minimum(int y, int from, int to) const {
  const size_t length = static_cast<size_t>(to - from + 1);
  const size_t level = static_cast<size_t>(std::bit_width(length) - 1);
  const size_t begin = static_cast<size_t>(y - region_.y0) * static_cast<size_t>(region_.x1 - region_.x0) +
                       static_cast<size_t>(from - region_.x0);
  return std::min(levels_[level][begin], levels_[level][begin + length - (size_t{1} << level)]);
}

float DiscMinimum::minimum(int x, int y, double radius_px, float enough) const {
  float least = std::numeric_limits<float>::infinity();
  for (int dy = 0; dy <= static_cast<int>(radius_px); ++dy) {
    const int half = static_cast<int>(std::sqrt(radius_px * radius_px - static_cast<double>(dy) * dy));
    const int from = std::max(region_.x0, x - half), to = std::min(region_.x1 - 1, x + half);
    if (y - dy >= region_.y0) least = std::min(least, run_minimum(y - dy, from, to));
    if (dy > 0 && y + dy < region_.y1) least = std::min(least, run_minimum(y + dy, from, to));
    if (least <= enough) break;
  }
  return least;
}

}  // namespace umbrameter

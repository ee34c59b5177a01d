// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/nearest_feature.h"

#include "core/error.h"
#include "metrics/image/tiles.h"

#include <cmath>

namespace umbrameter {

namespace {

constexpr int32_t kNoFeature = -1;

// Row of the nearest feature in the same column, for every pixel of columns x0 <= x < x1; rows are walked as
// a whole so that memory is read in order.
void nearest_in_columns(std::span<const uint8_t> is_feature, int width, int height, int x0, int x1,
                        std::vector<int32_t>& row_of) {
  const auto at = [width](int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = x0; x < x1; ++x) {
      if (is_feature[at(x, y)] != 0) {
        row_of[at(x, y)] = y;
      } else {
        row_of[at(x, y)] = y > 0 ? row_of[at(x, y - 1)] : kNoFeature;
      }
    }
  }
  for (int y = height - 2; y >= 0; --y) {
    for (int x = x0; x < x1; ++x) {
      const int32_t above = row_of[at(x, y)], below = row_of[at(x, y + 1)];
      if (below != kNoFeature && (above == kNoFeature || below - y < y - above)) row_of[at(x, y)] = below;
    }
  }
}

// One parabola (x - column)^2 + height_squared of the lower envelope, lowest from `begin` on.
struct Parabola {
  int32_t column = 0, row = 0;
  int64_t height_squared = 0;
  int64_t begin = 0;

  int64_t at(int64_t x) const { return (x - column) * (x - column) + height_squared; }
};

// First integer x from which `right` is at or below `left`; left.column < right.column.
int64_t takes_over(const Parabola& left, const Parabola& right) {
  const int64_t numerator = int64_t{right.column} * right.column - int64_t{left.column} * left.column +
                            right.height_squared - left.height_squared;
  const int64_t denominator = 2 * (int64_t{right.column} - left.column);
  const int64_t quotient = numerator / denominator;
  return quotient + (numerator % denominator > 0 ? 1 : 0);
}

void nearest_in_row(int width, int y, std::span<const int32_t> row_of, std::vector<Parabola>& envelope,
                    std::span<int32_t> nearest) {
  envelope.clear();
  for (int x = 0; x < width; ++x) {
    const int32_t row = row_of[static_cast<size_t>(x)];
    if (row == kNoFeature) continue;
    Parabola next = {x, row, int64_t{row - y} * (row - y), 0};
    while (!envelope.empty()) {
      next.begin = std::max(int64_t{0}, takes_over(envelope.back(), next));
      if (next.begin > envelope.back().begin) break;
      envelope.pop_back();
      next.begin = 0;
    }
    if (next.begin < width) envelope.push_back(next);
  }
  size_t k = 0;
  for (int x = 0; x < width; ++x) {
    if (envelope.empty()) {
      nearest[static_cast<size_t>(x)] = kNoFeature;
      continue;
    }
    while (k + 1 < envelope.size() && envelope[k + 1].begin <= x) ++k;
    nearest[static_cast<size_t>(x)] = envelope[k].row * width + envelope[k].column;
  }
}

}  // namespace

std::vector<int32_t> nearest_feature(std::span<const uint8_t> is_feature, int width, int height) {
  const size_t columns = static_cast<size_t>(width);
  UMBRAMETER_ASSERT(is_feature.size() == columns * static_cast<size_t>(height), "{} pixels",
                    is_feature.size());
  std::vector<int32_t> row_of(is_feature.size(), kNoFeature), nearest(is_feature.size(), kNoFeature);
  constexpr int kColumnsAtOnce = 64;
  for_each_row((width + kColumnsAtOnce - 1) / kColumnsAtOnce, [&](int block) {
    const int x0 = block * kColumnsAtOnce;
    nearest_in_columns(is_feature, width, height, x0, std::min(x0 + kColumnsAtOnce, width), row_of);
  });
  for_each_row(height, [&](int y) {
    std::vector<Parabola> envelope;
    const size_t begin = static_cast<size_t>(y) * columns;
    nearest_in_row(width, y, std::span(row_of).subspan(begin, columns), envelope,
                   std::span(nearest).subspan(begin, columns));
  });
  return nearest;
}

double distance_px(int64_t i, int64_t j, int width) {
  return std::hypot(static_cast<double>(i % width - j % width), static_cast<double>(i / width - j / width));
}

}  // namespace umbrameter

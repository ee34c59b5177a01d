// SPDX-License-Identifier: Apache-2.0
#pragma once
// FLIP's observer: a picture through his filters into his colour space, a piece of a row at a time.

#include "metrics/flip/flip_map.h"

#include <array>
#include <cstddef>
#include <functional>

namespace umbrameter {

/// Columns worked on together: what they need stays in the second cache.
inline constexpr int kFlipTile_px = 128;
using FlipTileRow = std::array<float, kFlipTile_px>;

/// Pixels x <= . < x + count of row y, as in SeenPicture; what lies beyond count is undefined, as are a and b of grey.
struct SeenRow {
  size_t x = 0, y = 0, count = 0;
  FlipTileRow lightness, a, b, edge, point;
};

/// Calls `visit` for every piece of the picture, from several threads.
void see_rows(const FlipSource& picture, int width, int height, double ppd,
              const std::function<void(const SeenRow&)>& visit);

}  // namespace umbrameter

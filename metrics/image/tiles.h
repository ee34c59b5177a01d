// SPDX-License-Identifier: Apache-2.0
#pragma once
// Square tiles of an image, visited in parallel, each with its own result, so that whoever adds the results
// up in tile order gets the same bits with any number of threads.

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace umbrameter {

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Tile {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Tiles of `tile_px` in reading order; those at the right and lower edge may be smaller.
struct TileGrid {
  int width = 0, height = 0, tile_px = 0;

  int columns() const { return (width + tile_px - 1) / tile_px; }
  int rows() const { return (height + tile_px - 1) / tile_px; }
  size_t count() const { return static_cast<size_t>(columns()) * static_cast<size_t>(rows()); }
  Tile tile(size_t index) const {
    const size_t across = static_cast<size_t>(columns());
    const int x = static_cast<int>(index % across) * tile_px;
    const int y = static_cast<int>(index / across) * tile_px;
    return {x, y, std::min(x + tile_px, width), std::min(y + tile_px, height)};
  }
};

/// body(i, result) for 0 <= i < count; results in that order.
template <class Result, class Body>
std::vector<Result> for_each_index(size_t count, const Body& body) {
  std::vector<Result> results(count);
  tbb::parallel_for(size_t{0}, count, [&](size_t i) { body(i, results[i]); });
  return results;
}

/// body(tile, result) for every tile; results in reading order.
template <class Result, class Body>
std::vector<Result> for_each_tile(const TileGrid& grid, const Body& body) {
  return for_each_index<Result>(grid.count(), [&](size_t i, Result& result) { body(grid.tile(i), result); });
}

/// body(i) for every pixel index of a tile, in reading order.
template <class Body>
void for_each_pixel(const TileGrid& grid, const Tile& tile, const Body& body) {
  for (int y = tile.y0; y < tile.y1; ++y) {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(grid.width);
    for (size_t i = row + static_cast<size_t>(tile.x0); i < row + static_cast<size_t>(tile.x1); ++i) body(i);
  }
}

/// body(y) for every row.
template <class Body>
void for_each_row(int height, const Body& body) {
  tbb::parallel_for(0, height, [&](int y) { body(y); });
}

}  // namespace umbrameter

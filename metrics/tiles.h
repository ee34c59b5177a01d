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

/// body(tile, result) for every tile; results in reading order.
template <class Result, class Body>
std::vector<Result> for_each_tile(const TileGrid& grid, const Body& body) {
  std::vector<Result> results(grid.count());
  tbb::parallel_for(size_t{0}, grid.count(), [&](size_t i) { body(grid.tile(i), results[i]); });
  return results;
}

/// body(y) for every row.
template <class Body>
void for_each_row(int height, const Body& body) {
  tbb::parallel_for(0, height, [&](int y) { body(y); });
}

}  // namespace umbrameter

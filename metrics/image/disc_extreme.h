// SPDX-License-Identifier: Apache-2.0
#pragma once
// Least value of a plane within discs of any radius around the pixels of one tile.

#include "metrics/image/tiles.h"

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// A sparse table (power-of-two runs) along the rows of a tile and its surroundings: a disc of radius r is 2
/// r + 1 runs of two look-ups each. Unmasked pixels do not count.
class DiscMinimum {
 public:
  /// Of sign * plane, so that sign -1 finds the greatest. Discs may have up to `max_radius_px`.
  DiscMinimum(std::span<const float> plane, std::span<const uint8_t> mask, const TileGrid& image,
              const Tile& tile, double max_radius_px, float sign);

  /// The least value within `radius_px` of pixel (x, y) of the tile, or any value at or below `enough`,
  /// whichever is found first.
  float minimum(int x, int y, double radius_px, float enough) const;

 private:
  float run_minimum(int y, int from, int to) const;

  Tile region_;
  std::vector<std::vector<float>> levels_;  // level k: least of 2^k pixels from this one on
};

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "metrics/statistics/seed_noise.h"

#include "core/error.h"

#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kNoiseTile_px = 32;

std::vector<double> tile_sums(const Image& picture, const Image& truth, std::span<const uint8_t> mask) {
  const auto v = picture.plane("visibility");
  const auto a = truth.plane("half_a"), b = truth.plane("half_b");
  const auto width = static_cast<size_t>(truth.width);
  const size_t columns = (width + kNoiseTile_px - 1) / kNoiseTile_px;
  const size_t rows = (static_cast<size_t>(truth.height) + kNoiseTile_px - 1) / kNoiseTile_px;
  std::vector<double> sums(columns * rows, 0.0);
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    const size_t tile = (i / width / kNoiseTile_px) * columns + i % width / kNoiseTile_px;
    sums[tile] += (static_cast<double>(v[i]) - a[i]) * (static_cast<double>(v[i]) - b[i]);
  }
  return sums;
}

}  // namespace

double seed_noise_of_mse(std::span<const Image> pictures, const Image& truth, std::span<const uint8_t> mask) {
  UMBRAMETER_ASSERT(pictures.size() >= 2, "one picture has no noise to be seen");
  double pixels = 0.0;
  for (const uint8_t scored : mask) pixels += scored != 0 ? 1.0 : 0.0;
  if (pixels == 0.0) return 0.0;
  const double count = static_cast<double>(pictures.size());
  std::vector<double> sums, squares;
  for (const Image& picture : pictures) {
    const std::vector<double> tiles = tile_sums(picture, truth, mask);
    sums.resize(tiles.size(), 0.0);
    squares.resize(tiles.size(), 0.0);
    for (size_t k = 0; k < tiles.size(); ++k) {
      sums[k] += tiles[k];
      squares[k] += tiles[k] * tiles[k];
    }
  }
  double variance = 0.0;  // of the tiles' sums, unbiased, added up
  for (size_t k = 0; k < sums.size(); ++k)
    variance += std::max(0.0, squares[k] - sums[k] * sums[k] / count) / (count - 1.0);
  return std::sqrt(variance) / pixels;
}

}  // namespace umbrameter

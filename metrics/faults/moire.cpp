// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/moire.h"

#include "core/error.h"
#include "core/statistics.h"
#include "metrics/image/checks.h"
#include "metrics/image/texel_footprint.h"
#include "metrics/image/tiles.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace umbrameter {

namespace {

constexpr int kSide = 32;                // of a tile
constexpr int kHalfSide = kSide / 2;     // Nyquist
constexpr int kLowest = 3;               // cycles a tile; below, the window's own shape dominates
constexpr double kLargestTexelPx = 8.0;  // four cycles a tile
constexpr size_t kFewestAcnePixels = kSide * kSide / 16;
constexpr size_t kMostTiles = 512;
// Of the mean power. The largest of 500 bins of noise exceeds 12 in 0.3 % of the tiles, and a rim of the acne
// within the tile may double that; stripes reach 100.
constexpr double kPeak = 25.0;

using Field = std::array<std::array<double, kSide>, kSide>;

struct Frequency {
  double x = 0.0, y = 0.0;  // cycles per pixel
};

struct TilePeak {
  std::optional<double> cycles_per_px, cycles_per_texel;
};

struct Input {
  std::span<const float> v, r;
  std::span<const FaultClass> classes;
  SurfaceView surface;
  TexelView texels;
};

std::complex<double> turn(int k) {
  static const auto kTable = [] {
    std::array<std::complex<double>, kSide> table;
    for (int i = 0; i < kSide; ++i) {
      table[static_cast<size_t>(i)] = std::polar(1.0, -2.0 * std::numbers::pi * i / kSide);
    }
    return table;
  }();
  return kTable[static_cast<size_t>(k & (kSide - 1))];
}

double hann(int i) {
  return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (i + 0.5) / kSide);
}

// The acne's error less its mean, faded out towards the tile's rim.
Field windowed_error(const Input& input, const Tile& tile) {
  Field field{};
  double sum = 0.0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const size_t i = static_cast<size_t>(tile.y0 + y) * static_cast<size_t>(input.surface.width) +
                       static_cast<size_t>(tile.x0 + x);
      if (input.classes[i] != FaultClass::acne) continue;
      field[y][x] = static_cast<double>(input.v[i]) - input.r[i];
      sum += field[y][x];
    }
  }
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) field[y][x] = (field[y][x] - sum / (kSide * kSide)) * hann(x) * hann(y);
  }
  return field;
}

// power[ky][kx + kHalfSide], ky from 0: a real field's other half is the same.
using Spectrum = std::array<std::array<double, kSide>, kHalfSide + 1>;

Spectrum power_of(const Field& field) {
  std::array<std::array<std::complex<double>, kSide>, kSide> rows{};
  for (int y = 0; y < kSide; ++y) {
    for (int k = 0; k < kSide; ++k) {
      for (int x = 0; x < kSide; ++x) rows[y][k] += field[y][x] * turn((k - kHalfSide) * x);
    }
  }
  Spectrum power{};
  for (int ky = 0; ky <= kHalfSide; ++ky) {
    for (int k = 0; k < kSide; ++k) {
      std::complex<double> sum = 0.0;
      for (int y = 0; y < kSide; ++y) sum += rows[y][k] * turn(ky * y);
      power[ky][k] = std::norm(sum);
    }
  }
  return power;
}

// The centre of mass of the strongest bin and its neighbours.
std::optional<Frequency> peak_of(const Spectrum& power) {
  int peak_x = 0, peak_y = 0;
  double highest = 0.0, sum = 0.0, bins = 0.0;
  for (int ky = 0; ky <= kHalfSide; ++ky) {
    for (int k = 0; k < kSide; ++k) {
      const int kx = k - kHalfSide;
      if (kx * kx + ky * ky < kLowest * kLowest) continue;
      sum += power[ky][k];
      bins += 1.0;
      if (power[ky][k] <= highest) continue;
      highest = power[ky][k];
      peak_x = k;
      peak_y = ky;
    }
  }
  if (!(highest > kPeak * sum / bins)) return std::nullopt;
  double mass = 0.0, x = 0.0, y = 0.0;
  for (int ky = std::max(0, peak_y - 1); ky <= std::min(kHalfSide, peak_y + 1); ++ky) {
    for (int k = std::max(0, peak_x - 1); k <= std::min(kSide - 1, peak_x + 1); ++k) {
      if ((k - kHalfSide) * (k - kHalfSide) + ky * ky < kLowest * kLowest) continue;
      mass += power[ky][k];
      x += power[ky][k] * (k - kHalfSide);
      y += power[ky][k] * ky;
    }
  }
  return Frequency{x / mass / kSide, y / mass / kSide};
}

// Mean over the tile's acne; unknown where a texel may be smaller than two pixels or too large for the tile.
TexelStep step_in(const Input& input, const TileGrid& grid, const Tile& tile) {
  TexelStep sum;
  double count = 0.0;
  for_each_pixel(grid, tile, [&](size_t i) {
    if (input.classes[i] != FaultClass::acne) return;
    const TexelStep step = texel_step(input.texels, input.surface, i);
    if (!step.known) return;
    sum.xx += step.xx, sum.xy += step.xy, sum.yx += step.yx, sum.yy += step.yy;
    count += 1.0;
  });
  if (count == 0.0) return {};
  const TexelStep mean = {sum.xx / count, sum.xy / count, sum.yx / count, sum.yy / count, true};
  const bool has_countable_texels = std::hypot(mean.xx, mean.yx) < 0.5 &&
                                    std::hypot(mean.xy, mean.yy) < 0.5 &&
                                    footprint_px(mean) <= kLargestTexelPx;
  return has_countable_texels ? mean : TexelStep{};
}

// A wave's phase is the same in pixels and in texels: f_px = transpose(step) f_texel.
std::optional<double> per_texel(const Frequency& f, const TexelStep& step) {
  const double determinant = step.xx * step.yy - step.xy * step.yx;
  if (!step.known || determinant == 0.0) return std::nullopt;
  return std::hypot(step.yy * f.x - step.yx * f.y, step.xx * f.y - step.xy * f.x) / std::abs(determinant);
}

TilePeak measure_tile(const Input& input, const TileGrid& grid, const Tile& tile) {
  size_t acne = 0;
  for_each_pixel(grid, tile, [&](size_t i) { acne += input.classes[i] == FaultClass::acne ? 1 : 0; });
  if (acne < kFewestAcnePixels) return {};
  const auto peak = peak_of(power_of(windowed_error(input, tile)));
  if (!peak) return {};
  return {std::hypot(peak->x, peak->y), per_texel(*peak, step_in(input, grid, tile))};
}

}  // namespace

Moire measure_moire(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                    const Faults& faults) {
  require_same_size(test, reference, "moire");
  require_mask_size(reference, mask, "moire");
  require_visibility(test, "visibility", mask);
  require_visibility(reference, "visibility", mask);
  UMBRAMETER_ASSERT(faults.classes.size() == mask.size(), "faults of {} pixels", faults.classes.size());
  if (faults.of(FaultClass::acne).pixels < kFewestAcnePixels) return {};
  const Input input = {test.plane("visibility"), reference.plane("visibility"), faults.classes,
                       checked_surface(reference), checked_texels(test, mask)};

  // Whole tiles only.
  const TileGrid grid = {test.width / kSide * kSide, test.height / kSide * kSide, kSide};
  const TileGrid image = {test.width, test.height, kSide};
  const size_t stride = (grid.count() + kMostTiles - 1) / kMostTiles;
  const auto peaks = for_each_index<TilePeak>(
      stride == 0 ? 0 : (grid.count() + stride - 1) / stride,
      [&](size_t k, TilePeak& peak) { peak = measure_tile(input, image, grid.tile(k * stride)); });

  std::vector<double> per_px, per_texel_values;
  for (const TilePeak& peak : peaks) {
    if (peak.cycles_per_px) per_px.push_back(*peak.cycles_per_px);
    if (peak.cycles_per_texel) per_texel_values.push_back(*peak.cycles_per_texel);
  }
  return {per_px.size(), median_if_any(per_px), median_if_any(per_texel_values)};
}

}  // namespace umbrameter

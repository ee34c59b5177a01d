// SPDX-License-Identifier: Apache-2.0
#include "metrics/causes/causes.h"

#include "core/error.h"
#include "core/statistics.h"
#include "metrics/image/checks.h"
#include "metrics/image/texel_footprint.h"
#include "metrics/image/tiles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

constexpr size_t kFootprintBins = kFootprintBinsPx.size();
constexpr int kCauseTilePx = 64;
constexpr int kTrendPx = 40;  // neighbours along the contour: five cells of profiles to either side
constexpr size_t kFewestNeighbours = 4;
constexpr double kStairPx = 2.0;  // smaller texels' stairs drown in the pixels' own
constexpr size_t kFewestRampPx = 8;
constexpr double kMostNoiseError = 0.005;  // of the truth's own; four such medians in a comparison: .01
const double kSigmaPerResidual = std::sqrt(9.0 / 8.0);  // the mean of nine holds a ninth of the pixel itself

struct Pair {
  std::span<const float> v, r;
  std::span<const uint8_t> mask;
  SurfaceView surface;
  TexelView texels;
};

struct FootprintSums {
  std::array<size_t, kFootprintBins + 1> pixels{};  // the last one: unknown
  std::array<double, kFootprintBins + 1> errors{};
};

size_t bin_of(double footprint) {
  if (!(footprint > 0.0)) return kFootprintBins;
  const auto above = std::upper_bound(kFootprintBinsPx.begin(), kFootprintBinsPx.end(), footprint);
  return static_cast<size_t>(above - kFootprintBinsPx.begin()) - 1;
}

void add_footprints(const Pair& pair, ErrorCauses& out) {
  const std::vector<float> footprints = footprints_px(pair.texels, pair.surface, pair.mask);
  const TileGrid grid = {pair.surface.width, pair.surface.height, kCauseTilePx};
  const auto tiles = for_each_tile<FootprintSums>(grid, [&](const Tile& tile, FootprintSums& sums) {
    for_each_pixel(grid, tile, [&](size_t i) {
      if (pair.mask[i] == 0) return;
      const size_t bin = bin_of(footprints.empty() ? 0.0 : footprints[i]);
      ++sums.pixels[bin];
      sums.errors[bin] += std::abs(static_cast<double>(pair.v[i]) - pair.r[i]);
    });
  });
  FootprintSums total;
  for (const FootprintSums& tile : tiles) {
    for (size_t k = 0; k <= kFootprintBins; ++k) {
      total.pixels[k] += tile.pixels[k];
      total.errors[k] += tile.errors[k];
    }
  }
  for (const size_t pixels : total.pixels) out.scored_pixels += pixels;
  if (out.scored_pixels == 0) return;
  out.mean_abs_error = 0.0;
  for (size_t k = 0; k <= kFootprintBins; ++k) {
    FootprintBin& bin = k < kFootprintBins ? out.by_footprint[k] : out.unknown;
    bin = {total.pixels[k], total.errors[k] / static_cast<double>(out.scored_pixels)};
    *out.mean_abs_error += bin.mean_abs_error;
  }
  std::vector<float> known;
  std::copy_if(footprints.begin(), footprints.end(), std::back_inserter(known),
               [](float f) { return f > 0.0f; });
  out.median_footprint_px = median_if_any(std::move(known));
}

struct Edge {
  int x = 0, y = 0;
  size_t pixel = 0;
  double offset_world = 0.0;
};

// Profiles come in reading order of cells, so neighbours lie in a band of rows.
std::optional<double> stair_of(const Pair& pair, std::span<const Edge> edges, size_t at, size_t& first) {
  const Edge& edge = edges[at];
  while (edges[first].y < edge.y - 2 * kTrendPx) ++first;
  double sum = 0.0;
  size_t count = 0;
  for (size_t k = first; k < edges.size() && edges[k].y <= edge.y + 2 * kTrendPx; ++k) {
    const Edge& other = edges[k];
    if (k == at || std::abs(other.x - edge.x) > kTrendPx || std::abs(other.y - edge.y) > kTrendPx) continue;
    if (!same_surface(pair.surface, edge.pixel, other.pixel)) continue;
    sum += other.offset_world;
    ++count;
  }
  if (count < kFewestNeighbours) return std::nullopt;
  // Against the mean of n others the deviation is sqrt(1 + 1/n) too large.
  const double n = static_cast<double>(count);
  return (edge.offset_world - sum / n) / std::sqrt(1.0 + 1.0 / n) / pair.texels.width_world[edge.pixel];
}

void add_stairs(const Pair& pair, std::span<const PenumbraProfile> profiles, ErrorCauses& out) {
  if (!pair.texels.known()) return;
  std::vector<Edge> edges;
  for (const PenumbraProfile& p : profiles) {
    const size_t pixel = p.pixel(pair.surface.width);
    if (!p.edge_offset_world) continue;
    if (footprint_px(texel_step(pair.texels, pair.surface, pixel)) < kStairPx) continue;
    edges.push_back({p.x, p.y, pixel, *p.edge_offset_world});
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.y < b.y; });
  double squares = 0.0;
  size_t first = 0;
  for (size_t k = 0; k < edges.size(); ++k) {
    const auto deviation = stair_of(pair, edges, k, first);
    if (!deviation) continue;
    squares += *deviation * *deviation;
    ++out.stair_profiles;
  }
  if (out.stair_profiles > 0) out.stair_texels = std::sqrt(squares / static_cast<double>(out.stair_profiles));
}

void add_banding(std::span<const PenumbraProfile> profiles, ErrorCauses& out) {
  std::vector<double> banding, levels;
  for (const PenumbraProfile& p : profiles) {
    if (p.outcome != ProfileOutcome::accepted || p.ramp_px < kFewestRampPx) continue;
    levels.push_back(static_cast<double>(p.ramp_levels));
    banding.push_back(1.0 - levels.back() / static_cast<double>(p.ramp_px));
  }
  out.banding_profiles = levels.size();
  out.banding = median_if_any(std::move(banding));
  out.levels = median_if_any(std::move(levels));
}

struct Residuals {
  std::vector<double> test, reference;
};

// Distances from the 3 x 3 mean; a pixel without eight scored neighbours on its surface has none.
void add_residual(const Pair& pair, size_t i, Residuals& out) {
  const size_t width = static_cast<size_t>(pair.surface.width);
  double v = 0.0, r = 0.0;
  for (const size_t row : {i - width, i, i + width}) {
    for (const size_t j : {row - 1, row, row + 1}) {
      if (pair.mask[j] == 0 || !same_surface(pair.surface, i, j)) return;
      v += pair.v[j];
      r += pair.r[j];
    }
  }
  out.test.push_back(std::abs(pair.v[i] - v / 9.0));
  out.reference.push_back(std::abs(pair.r[i] - r / 9.0));
}

// Standard error of the median, without a distribution: the count below it is binomial, n / 2 +- sqrt(n) / 2. Infinite for
// nothing.
double error_of_median(std::vector<double> values) {
  if (values.empty()) return HUGE_VAL;
  const auto n = static_cast<double>(values.size());
  const auto at = [&](double rank) {
    const auto index = static_cast<size_t>(std::clamp(rank, 0.0, n - 1.0));
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(index));
    return values[index];
  };
  const double above = at(0.5 * (n + std::sqrt(n)));
  return 0.5 * (above - at(0.5 * (n - std::sqrt(n))));
}

void add_noise(const Pair& pair, ErrorCauses& out) {
  const TileGrid grid = {pair.surface.width, pair.surface.height, kCauseTilePx};
  const auto tiles = for_each_tile<Residuals>(grid, [&](Tile tile, Residuals& residuals) {
    tile = {std::max(tile.x0, 1), std::max(tile.y0, 1), std::min(tile.x1, grid.width - 1),
            std::min(tile.y1, grid.height - 1)};
    for_each_pixel(grid, tile, [&](size_t i) {
      if (pair.mask[i] != 0 && pair.r[i] > 0.05f && pair.r[i] < 0.95f) add_residual(pair, i, residuals);
    });
  });
  Residuals all;
  for (const Residuals& tile : tiles) {
    all.test.insert(all.test.end(), tile.test.begin(), tile.test.end());
    all.reference.insert(all.reference.end(), tile.reference.begin(), tile.reference.end());
  }
  const double scale = kSigmaPerMedian * kSigmaPerResidual;
  if (!(scale * error_of_median(all.reference) <= kMostNoiseError)) return;
  if (const auto median = median_if_any(std::move(all.test))) out.noise = scale * *median;
  if (const auto median = median_if_any(std::move(all.reference))) out.reference_noise = scale * *median;
}

}  // namespace

ErrorCauses measure_causes(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                           std::span<const PenumbraProfile> profiles) {
  require_same_size(test, reference, "causes");
  require_mask_size(reference, mask, "causes");
  require_visibility(test, "visibility", mask);
  require_visibility(reference, "visibility", mask);
  const Pair pair = {test.plane("visibility"), reference.plane("visibility"), mask,
                     checked_surface(reference), checked_texels(test, mask)};
  ErrorCauses out;
  add_footprints(pair, out);
  add_stairs(pair, profiles, out);
  add_banding(profiles, out);
  add_noise(pair, out);
  return out;
}

}  // namespace umbrameter

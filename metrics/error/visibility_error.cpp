// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/visibility_error.h"

#include "core/error.h"
#include "core/statistics.h"
#include "metrics/image/checks.h"
#include "metrics/image/tiles.h"
#include "metrics/statistics/bootstrap.h"

#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

struct RegionSums {
  size_t pixels = 0;
  double product = 0.0;  // (V - A)(V - B)
  double signed_error = 0.0;
};

struct TileSums {
  std::array<RegionSums, 3> regions;  // indexed by Region
  double dark = 0.0, bright = 0.0;    // max(0, R - V), max(0, V - R)
  double variance = 0.0;
  double product_variance = 0.0;  // of the products' sum, from the reference's noise
  double max_error = 0.0;
  bool in_range = true;
};

struct ErrorPlanes {
  std::span<const float> v, r, a, b, se;
};

Region region_of(float visibility, double epsilon) {
  if (visibility > 1.0 - epsilon) return Region::lit;
  if (visibility < epsilon) return Region::umbra;
  return Region::penumbra;
}

bool is_visibility(float value) {
  return value >= -kVisibilityRounding && value <= 1.0f + kVisibilityRounding;
}

void add_pixel(const ErrorPlanes& planes, size_t i, double epsilon, TileSums& sums) {
  const float v = planes.v[i], r = planes.r[i], a = planes.a[i], b = planes.b[i], se = planes.se[i];
  const bool in_range = is_visibility(v) && is_visibility(r) && is_visibility(a) && is_visibility(b) &&
                        se >= 0.0f && std::isfinite(se);
  if (!in_range) {
    sums.in_range = false;
    return;
  }
  const double error = static_cast<double>(v) - r;
  RegionSums& region = sums.regions[static_cast<size_t>(region_of(r, epsilon))];
  region.pixels += 1;
  region.product += (static_cast<double>(v) - a) * (static_cast<double>(v) - b);
  region.signed_error += error;
  sums.dark += std::max(0.0, -error);
  sums.bright += std::max(0.0, error);
  // Each half has variance 2 se^2: var (V - A)(V - B) = 4 e^2 se^2 + 4 se^4, and error^2 estimates e^2 + se^2.
  const double variance = static_cast<double>(se) * se;
  sums.variance += variance;
  sums.product_variance += 4.0 * error * error * variance;
  sums.max_error = std::max(sums.max_error, std::abs(error));
}

void require_error_inputs(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  require_visibility(test, "visibility", mask);
  for (const char* channel : {"visibility", "half_a", "half_b"}) require_visibility(reference, channel, mask);
  require_range(reference, "visibility_se", mask, 0.0f, std::numeric_limits<float>::max());
}

void add(const TileSums& tile, TileSums& total) {
  for (size_t k = 0; k < total.regions.size(); ++k) {
    total.regions[k].pixels += tile.regions[k].pixels;
    total.regions[k].product += tile.regions[k].product;
    total.regions[k].signed_error += tile.regions[k].signed_error;
  }
  total.dark += tile.dark;
  total.bright += tile.bright;
  total.variance += tile.variance;
  total.product_variance += tile.product_variance;
  total.max_error = std::max(total.max_error, tile.max_error);
  total.in_range = total.in_range && tile.in_range;
}

TileSum product_sum(const TileSums& tile) {
  TileSum out;
  for (const RegionSums& region : tile.regions) {
    out.sum += region.product;
    out.weight += static_cast<double>(region.pixels);
  }
  return out;
}

RegionError region_error(const RegionSums& sums, double scored) {
  if (sums.pixels == 0) return {};
  const double pixels = static_cast<double>(sums.pixels);
  return {sums.pixels, pixels / scored, sums.product / pixels, sums.signed_error / pixels};
}

// With a single tile nothing is known of the spread, so the interval is all that (V - A)(V - B) can be.
Interval mse_interval(std::span<const TileSums> tiles, const VisibilityErrorSettings& settings) {
  std::vector<TileSum> sums(tiles.size());
  TileSum total;
  for (size_t i = 0; i < tiles.size(); ++i) {
    sums[i] = product_sum(tiles[i]);
    total.sum += sums[i].sum;
    total.weight += sums[i].weight;
  }
  const BootstrapInterval interval =
      bootstrap_ratio(sums, settings.bootstrap_rounds, settings.seed).value_or(BootstrapInterval{-1.0, 1.0});
  return {total.sum / total.weight, interval.low, interval.high};
}

void require_settings(const VisibilityErrorSettings& settings) {
  if (settings.tile_px < 1) fail_input(fmt::format("tile_px is {}", settings.tile_px), {}, "at least 1");
  if (!(settings.region_epsilon > 0.0 && settings.region_epsilon < 0.5)) {
    fail_input(fmt::format("region_epsilon is {}", settings.region_epsilon), {}, "between 0 and 0.5");
  }
}

}  // namespace

VisibilityError measure_visibility_error(const Image& test, const Image& reference,
                                         std::span<const uint8_t> mask,
                                         const VisibilityErrorSettings& settings) {
  require_settings(settings);
  require_same_size(test, reference, "visibility error");
  require_mask_size(test, mask, "visibility error");
  const ErrorPlanes planes = {test.plane("visibility"), reference.plane("visibility"),
                              reference.plane("half_a"), reference.plane("half_b"),
                              reference.plane("visibility_se")};

  const TileGrid grid = {test.width, test.height, settings.tile_px};
  const std::vector<TileSums> tiles = for_each_tile<TileSums>(grid, [&](const Tile& tile, TileSums& sums) {
    for (int y = tile.y0; y < tile.y1; ++y) {
      const size_t row = static_cast<size_t>(y) * static_cast<size_t>(grid.width);
      for (size_t i = row + static_cast<size_t>(tile.x0); i < row + static_cast<size_t>(tile.x1); ++i) {
        if (mask[i] != 0) add_pixel(planes, i, settings.region_epsilon, sums);
      }
    }
  });

  TileSums total;
  for (const TileSums& tile : tiles) add(tile, total);
  if (!total.in_range) require_error_inputs(test, reference, mask);

  VisibilityError out;
  for (const RegionSums& region : total.regions) out.scored_pixels += region.pixels;
  if (out.scored_pixels == 0) return out;

  const double scored = static_cast<double>(out.scored_pixels);
  out.mse = mse_interval(tiles, settings);
  out.rmse = {signed_root(out.mse->value), signed_root(out.mse->low), signed_root(out.mse->high)};
  out.over_shadowing = total.dark / scored;
  out.under_shadowing = total.bright / scored;
  out.mae = (total.dark + total.bright) / scored;
  out.bias = (total.bright - total.dark) / scored;
  out.noise_floor_mse = total.variance / scored;
  out.max_error = total.max_error;
  out.mse_noise_sd = std::sqrt(total.product_variance) / scored;
  out.lit = region_error(total.regions[static_cast<size_t>(Region::lit)], scored);
  out.umbra = region_error(total.regions[static_cast<size_t>(Region::umbra)], scored);
  out.penumbra = region_error(total.regions[static_cast<size_t>(Region::penumbra)], scored);
  return out;
}

}  // namespace umbrameter

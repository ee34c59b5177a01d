// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/verdict.h"

#include "core/error.h"
#include "metrics/image/checks.h"
#include "metrics/image/tiles.h"
#include "metrics/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

struct PairSums {
  TileSum difference, baseline;
  double noise_variance = 0.0;  // of difference.sum, from the reference's samples alone
};

struct PairPlanes {
  std::span<const float> candidate, baseline, r, a, b, se;
};

// (C - A)(C - B) - (D - A)(D - B) = (C - D)(C + D - A - B): the reference's noise enters only where the images differ.
void add_pixel(const PairPlanes& planes, size_t i, PairSums& sums) {
  const double c = planes.candidate[i], d = planes.baseline[i], a = planes.a[i], b = planes.b[i];
  sums.difference.sum += (c - d) * (c + d - a - b);
  sums.baseline.sum += (d - a) * (d - b);
  sums.difference.weight += 1.0;
  const double noise = 2.0 * (c - d) * planes.se[i];
  sums.noise_variance += noise * noise;
}

void require_pair_inputs(const Image& candidate, const Image& baseline, const Image& reference,
                         std::span<const uint8_t> mask) {
  require_same_size(candidate, reference, "verdict");
  require_same_size(baseline, reference, "verdict");
  require_mask_size(reference, mask, "verdict");
  require_visibility(candidate, "visibility", mask);
  require_visibility(baseline, "visibility", mask);
  for (const char* channel : {"visibility", "half_a", "half_b"}) require_visibility(reference, channel, mask);
  require_range(reference, "visibility_se", mask, 0.0f, std::numeric_limits<float>::max());
}

// An interval's half width is that of the places and that of the samples, in quadrature; only the second shrinks, at
// worst with the root of their number. The factor at which it is `wanted`.
std::optional<double> factor_for(double wanted, double half_width, double noise_sd) {
  const double noise = 1.96 * noise_sd;
  const double places = std::sqrt(std::max(0.0, half_width * half_width - noise * noise));
  if (!(noise > 0.0) || !(wanted > places)) return std::nullopt;
  const double factor = noise * noise / (wanted * wanted - places * places);
  return factor > 1.0 ? std::optional(factor) : std::nullopt;
}

Comparison outcome_of(const Interval& difference, double same_within) {
  if (difference.low >= -same_within && difference.high <= same_within) return Comparison::same;
  if (difference.high < 0.0) return Comparison::better;
  if (difference.low > 0.0) return Comparison::worse;
  return Comparison::cannot_tell;
}

}  // namespace

std::string_view name_of(Comparison outcome) {
  switch (outcome) {
    case Comparison::better:
      return "better";
    case Comparison::worse:
      return "worse";
    case Comparison::same:
      return "same";
    case Comparison::cannot_tell:
      break;
  }
  return "cannot_tell";
}

std::string_view name_of(LimitOutcome outcome) {
  if (outcome == LimitOutcome::pass) return "pass";
  return outcome == LimitOutcome::fail ? "fail" : "cannot_tell";
}

std::optional<ComparisonVerdict> compare_runs(const Image& candidate, const Image& baseline,
                                              const Image& reference, std::span<const uint8_t> mask,
                                              const VerdictSettings& settings) {
  require_pair_inputs(candidate, baseline, reference, mask);
  if (settings.tile_px < 1) fail_input(fmt::format("tile_px is {}", settings.tile_px), {}, "at least 1");
  const PairPlanes planes = {candidate.plane("visibility"), baseline.plane("visibility"),
                             reference.plane("visibility"), reference.plane("half_a"),
                             reference.plane("half_b"),     reference.plane("visibility_se")};
  const TileGrid grid = {reference.width, reference.height, settings.tile_px};
  const std::vector<PairSums> tiles = for_each_tile<PairSums>(grid, [&](const Tile& tile, PairSums& sums) {
    for (int y = tile.y0; y < tile.y1; ++y) {
      const size_t row = static_cast<size_t>(y) * static_cast<size_t>(grid.width);
      for (size_t i = row + static_cast<size_t>(tile.x0); i < row + static_cast<size_t>(tile.x1); ++i) {
        if (mask[i] != 0) add_pixel(planes, i, sums);
      }
    }
  });

  std::vector<TileSum> differences;
  double difference = 0.0, baseline_error = 0.0, pixels = 0.0, noise_variance = 0.0;
  for (const PairSums& tile : tiles) {
    differences.push_back(tile.difference);
    difference += tile.difference.sum;
    pixels += tile.difference.weight;
    baseline_error += tile.baseline.sum;
    noise_variance += tile.noise_variance;
  }
  if (pixels == 0.0) return std::nullopt;

  ComparisonVerdict out;
  out.same_within = settings.same_share * std::max(0.0, baseline_error / pixels);
  const bool are_equal = noise_variance == 0.0 && difference == 0.0;
  const BootstrapInterval unknown = are_equal ? BootstrapInterval{} : BootstrapInterval{-1.0, 1.0};
  const BootstrapInterval interval =
      bootstrap_ratio(differences, settings.bootstrap_rounds, settings.seed).value_or(unknown);
  out.mse_difference = {difference / pixels, interval.low, interval.high};
  out.outcome = outcome_of(out.mse_difference, out.same_within);
  if (out.outcome != Comparison::cannot_tell) return out;
  const double half_width = 0.5 * (interval.high - interval.low), size = std::abs(out.mse_difference.value);
  out.sample_factor =
      factor_for(std::max(size, out.same_within - size), half_width, std::sqrt(noise_variance) / pixels);
  return out;
}

std::optional<LimitVerdict> judge_limit(const VisibilityError& error, double limit_rmse) {
  if (!(limit_rmse > 0.0)) fail_input(fmt::format("the limit is {}", limit_rmse), {}, "an RMSE above 0");
  if (!error.mse) return std::nullopt;
  const double limit = limit_rmse * limit_rmse;
  if (error.mse->high <= limit) return LimitVerdict{LimitOutcome::pass, {}};
  if (error.mse->low > limit) return LimitVerdict{LimitOutcome::fail, {}};
  LimitVerdict out;
  if (error.mse_noise_sd) {
    out.sample_factor = factor_for(std::abs(error.mse->value - limit),
                                   0.5 * (error.mse->high - error.mse->low), *error.mse_noise_sd);
  }
  return out;
}

}  // namespace umbrameter

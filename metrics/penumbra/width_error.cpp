// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/width_error.h"

#include "metrics/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kWidthRounds = 1000;

/// Of every profile that the truth has; absent for the others.
std::optional<double> squared_octaves(const PenumbraProfile& profile) {
  switch (profile.outcome) {
    case ProfileOutcome::accepted:
      return std::min(profile.width_octaves * profile.width_octaves, kLostOctaves * kLostOctaves);
    case ProfileOutcome::test_unreached:
    case ProfileOutcome::test_not_monotone:
      return kLostOctaves * kLostOctaves;
    default:
      return std::nullopt;
  }
}

std::vector<TileSum> squares_of(std::span<const PenumbraProfile> profiles) {
  std::vector<TileSum> squares;
  for (const PenumbraProfile& profile : profiles) {
    if (const auto squared = squared_octaves(profile)) squares.push_back({*squared, 1.0});
  }
  return squares;
}

}  // namespace

std::optional<double> measure_width_error(std::span<const PenumbraProfile> profiles) {
  TileSum total;
  for (const TileSum& square : squares_of(profiles)) {
    total.sum += square.sum;
    total.weight += square.weight;
  }
  return total.weight > 0.0 ? std::optional(std::sqrt(total.sum / total.weight)) : std::nullopt;
}

std::optional<Interval> width_error_interval(std::span<const PenumbraProfile> profiles) {
  const auto value = measure_width_error(profiles);
  if (!value) return std::nullopt;
  const auto interval = bootstrap_ratio(squares_of(profiles), kWidthRounds, 1);
  if (!interval) return std::nullopt;
  return Interval{*value, std::sqrt(interval->low), std::sqrt(interval->high)};
}

}  // namespace umbrameter

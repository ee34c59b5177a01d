// SPDX-License-Identifier: Apache-2.0
#pragma once
// Widths of a noisy edge profile: a monotone fit first, then moments and crossings of the fit (METRICS 5a:
// the largest gradient of a Monte Carlo profile is up to ten times too steep).

#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// Least-squares nondecreasing fit (pool adjacent violators), linear in the count.
std::vector<double> fit_nondecreasing(std::span<const double> values);

/// A rise, in the unit of `position`.
struct Transition {
  double width = 0.0;  // sqrt(12) times the standard deviation of the rise: the box ramp with that spread
  /// The same without the steps' own extent: 0 for a step between two samples, whatever their distance.
  double resolved_width = 0.0;
  double width_10_90 = 0.0;           // between the crossings of 10 % and 90 % of the rise
  double resolved_width_10_90 = 0.0;  // 0 where both lie between the same two samples
  double center = 0.0;                // mean position of the middle half of the rise: 25 % to 75 %
};

struct Levels {
  double low = 0.0, high = 1.0;
};

/// Of the rise between two levels. `fitted` nondecreasing over nondecreasing `position`, linear in between; absent when it
/// does not rise there.
std::optional<Transition> measure_transition(std::span<const double> position, std::span<const double> fitted,
                                             const Levels& levels);

/// Of the whole rise, from the first value to the last.
std::optional<Transition> measure_transition(std::span<const double> position,
                                             std::span<const double> fitted);

}  // namespace umbrameter

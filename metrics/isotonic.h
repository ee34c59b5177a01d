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

/// A rise from its first to its last value, in the unit of `position`.
struct Transition {
  double width = 0.0;  // sqrt(12) times the standard deviation of the rise: the box ramp with that spread
  double width_10_90 = 0.0;  // between the crossings of 10 % and 90 % of the rise
  double center = 0.0;       // crossing of 50 %
};

/// `fitted` nondecreasing over nondecreasing `position`, linear in between; absent when it does not rise.
std::optional<Transition> measure_transition(std::span<const double> position,
                                             std::span<const double> fitted);

}  // namespace umbrameter

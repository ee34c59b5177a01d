// SPDX-License-Identifier: Apache-2.0
#pragma once
// Confidence intervals of a ratio of sums whose terms are correlated inside a tile but not between tiles.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// One tile's share of sum / weight.
struct TileSum {
  double sum = 0.0;
  double weight = 0.0;
};

struct BootstrapInterval {
  double low = 0.0;
  double high = 0.0;
};

/// 95 % interval of sum(sum) / sum(weight) when tiles of positive weight are drawn with replacement.
/// Percentile method with the tail widened for few tiles (Hesterberg 2015, "What teachers should know about
/// the bootstrap", expanded percentile). Absent with fewer than two such tiles: there is no spread to learn
/// from. The same numbers for any thread count.
std::optional<BootstrapInterval> bootstrap_ratio(std::span<const TileSum> tiles, int rounds, uint64_t seed);

/// Two-sided 95 % quantile of Student's t with `degrees` >= 1 of freedom.
double student_t_975(int degrees);

}  // namespace umbrameter

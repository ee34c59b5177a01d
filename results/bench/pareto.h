// SPDX-License-Identifier: Apache-2.0
#pragma once
// One measured run, and which of several to take: the front of time against error, and the two questions people ask.

#include "metrics/statistics/frame_times.h"
#include "results/results.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// One run on one scene, with what a bench knows beside. It has no `error` when it failed or there is no truth to compare with.
struct BenchEntry : TechniqueResult {
  std::optional<double> compares_per_pixel;
  std::string picture_hash;  // of its visibility, to the bit; empty without one
  uint64_t seed = 0;
  FrameTimes times;
  std::optional<Interval> time_ms;  // median of a whole frame; absent when fewer than six were timed
  bool is_software = false;
  std::optional<std::string> dominated_by;  // label of a run that is faster and closer to the truth
  bool has_place = false;  // both intervals are known, so that `dominated_by` means something

  std::optional<Interval> rmse() const { return error ? error->rmse : std::nullopt; }
};

/// Sets `has_place` and `dominated_by`. A run is dominated when another's intervals of time and RMSE both lie below its
/// own; runs within each other's noise are not.
void find_front(std::vector<BenchEntry>& entries);

/// What fits, as indices: the best one first, then those that cannot be told apart from it.
using Ranking = std::vector<size_t>;

/// The smallest RMSE among runs whose time is surely under `limit_ms`.
Ranking best_under(std::span<const BenchEntry> entries, double limit_ms);
/// The shortest time among runs whose RMSE is surely below `limit`.
Ranking cheapest_below_rmse(std::span<const BenchEntry> entries, double limit);

}  // namespace umbrameter

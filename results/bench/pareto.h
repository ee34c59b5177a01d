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

/// One run on one scene. `rmse` is absent when the run failed or there is no truth to compare with; `time_ms` when fewer
/// than six frames were timed.
struct BenchEntry {
  std::string label;
  std::string technique;  // id
  std::string hash;       // of the technique's manifest and shaders
  ParameterValues parameters;
  std::optional<double> compares_per_pixel;
  std::string picture_hash;  // of its visibility, to the bit; empty without one
  uint64_t seed = 0;
  std::optional<Failure> failure;
  FrameTimes times;
  std::optional<Interval> time_ms;  // median of a whole frame
  std::optional<Interval> rmse;     // debiased
  std::optional<double> bias;
  uint64_t memory_bytes = 0;
  std::string device;
  bool is_software = false;
  std::string timer;
  std::vector<std::string> warnings;
  std::optional<std::string> dominated_by;  // label of a run that is faster and closer to the truth
  bool has_place = false;  // both intervals are known, so that `dominated_by` means something
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

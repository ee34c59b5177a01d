// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which run to take when nobody has named a limit of time or error.

#include "results/bench/bench_results.h"

#include <optional>
#include <span>
#include <string>

namespace umbrameter {

/// The run with the smallest product of time and RMSE, both at the upper ends of their intervals: from it, halving the one
/// costs more than doubling the other. Absent when no run has both intervals.
std::optional<size_t> recommended(std::span<const BenchEntry> entries);

/// The run that is best over all scenes.
struct OverallRecommendation {
  std::string label;
  double cost =
      1.0;  // geometric mean over the scenes of its product over that of the scene's recommended run
  size_t scenes = 0;
};

/// Among the runs that have both intervals in as many scenes as any has. Absent when none has.
std::optional<OverallRecommendation> recommended_overall(std::span<const BenchScene> scenes);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one rule by which a value of an axis breaks a technique.

#include "metrics/gate.h"
#include "results/stress/outcome.h"

#include <span>

namespace umbrameter {

/// A picture measured: what the gate needs, and how much there was to measure.
struct StressMeasure {
  GateRun run;
  size_t scored_pixels = 0;
};

/// Differences of visibility below this are none, whatever they are multiples of.
inline constexpr double kLeastStressLimit_rmse = 0.02;

/// The largest error that is still within twice the nominal one: both ends of the noise count for the technique.
double stress_limit_rmse(const Interval& nominal_rmse);

/// ok, worse, nothing, or unjudged without a nominal error. worse: the low end of the error's 95 % interval lies above
/// stress_limit_rmse(nominal); `how` is then the gate's class for the change.
StressCell judge_stress(const StressMeasure& measure, const StressMeasure* nominal);

/// Scores `picture` on tiles small enough for small pictures. What the metrics throw is the run's failure.
StressMeasure measure_stress(const Image& picture, const Image& reference, const glm::dvec3& eye_world);

}  // namespace umbrameter

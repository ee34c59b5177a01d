// SPDX-License-Identifier: Apache-2.0
#pragma once
// Time against error of the truth itself. Not here: measuring it (lab/truth_curve.h).

#include "metrics/statistics/frame_times.h"
#include "metrics/statistics/interval.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct TruthPoint {
  std::string kind;
  double setting = 0.0;
  MedianSpread cpu_s;  // processor time of the process, over the repetitions
  double rays_per_pixel = 0.0;
  std::optional<Interval> rmse;  // of visibility where there is a surface
};

struct TruthCurve {
  std::vector<TruthPoint> points;  // in the order of the settings
  /// With which power of the number the error of fixed samples falls; absent without two of them that err.
  std::optional<double> exponent;
};

/// The slope of log(error) over log(samples) by least squares; absent for fewer than two points.
std::optional<double> convergence_exponent(std::span<const TruthPoint> points);

}  // namespace umbrameter

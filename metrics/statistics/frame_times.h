// SPDX-License-Identifier: Apache-2.0
#pragma once
// Times of a run's frames, and what is said about them. Not here: how they come about (lab/timing.h).

#include "metrics/statistics/interval.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Time of one pass over the timed frames.
struct PassTime {
  std::string pass;
  double median_ms = 0.0;
  double mad_ms = 0.0;  // median absolute deviation
  int frames = 0;
};

struct FrameTimes {
  std::vector<std::string> passes;
  std::vector<std::vector<double>> frames_ms;  // [frame][pass]
};

/// Each pass in order, then "total": the sum of a frame's passes, frame by frame, then median and deviation. Empty
/// without frames.
std::vector<PassTime> summarise(const FrameTimes& times);

/// Each frame's sum over passes, less those in `without`.
std::vector<double> frame_totals(const FrameTimes& times, std::span<const std::string> without = {});
/// Each frame's time of `pass`; empty when there is no such pass.
std::vector<double> times_of_pass(const FrameTimes& times, const std::string& pass);

/// Median, and median absolute deviation from it; both 0 for an empty span.
struct MedianSpread {
  double median = 0.0;
  double mad = 0.0;
};
MedianSpread median_spread(std::span<const double> values);

/// The median between the two order statistics that enclose the true one with at least 95 % probability, whatever the
/// distribution. Absent for fewer than six values, where even their whole range does not.
std::optional<Interval> median_interval(std::span<const double> values);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "metrics/statistics/frame_times.h"

#include "core/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

/// Of `hits` heads in `n` throws of a fair coin.
double coin_probability(size_t n, size_t hits) {
  const auto log_factorial = [](size_t k) { return std::lgamma(static_cast<double>(k) + 1.0); };
  return std::exp(log_factorial(n) - log_factorial(hits) - log_factorial(n - hits) -
                  static_cast<double>(n) * std::numbers::ln2);
}

/// How many values may be cut off at each end: each lies below the true median with probability 1/2.
size_t cut_off(size_t n) {
  constexpr double kTail = 0.025;
  double below = 0.0;
  for (size_t k = 0;; ++k) {
    below += coin_probability(n, k);
    if (below > kTail) return k;
  }
}

PassTime pass_time(const std::string& pass, const std::vector<double>& values_ms) {
  const MedianSpread spread = median_spread(values_ms);
  return {pass, spread.median, spread.mad, static_cast<int>(values_ms.size())};
}

}  // namespace

std::vector<PassTime> summarise(const FrameTimes& times) {
  std::vector<PassTime> summary;
  if (times.frames_ms.empty()) return summary;
  for (const std::string& pass : times.passes) summary.push_back(pass_time(pass, times_of_pass(times, pass)));
  summary.push_back(pass_time("total", frame_totals(times)));
  return summary;
}

std::vector<double> frame_totals(const FrameTimes& times, std::span<const std::string> without) {
  std::vector<double> totals_ms;
  for (const std::vector<double>& frame : times.frames_ms) {
    double total_ms = 0.0;
    for (size_t pass = 0; pass < frame.size(); ++pass) {
      if (std::ranges::find(without, times.passes.at(pass)) == without.end()) total_ms += frame[pass];
    }
    totals_ms.push_back(total_ms);
  }
  return totals_ms;
}

std::vector<double> times_of_pass(const FrameTimes& times, const std::string& pass) {
  const auto found = std::ranges::find(times.passes, pass);
  if (found == times.passes.end()) return {};
  const auto index = static_cast<size_t>(found - times.passes.begin());
  std::vector<double> values_ms;
  for (const std::vector<double>& frame : times.frames_ms) values_ms.push_back(frame.at(index));
  return values_ms;
}

MedianSpread median_spread(std::span<const double> values) {
  if (values.empty()) return {};
  const double middle = median(std::vector<double>(values.begin(), values.end()));
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(std::abs(value - middle));
  return {middle, median(std::move(deviations))};
}

std::optional<Interval> median_interval(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const size_t cut = cut_off(sorted.size());
  if (cut == 0) return std::nullopt;
  return Interval{median(sorted), sorted[cut - 1], sorted[sorted.size() - cut]};
}

}  // namespace umbrameter

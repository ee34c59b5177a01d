// SPDX-License-Identifier: Apache-2.0
#include "study/tune/judge.h"

#include "core/error.h"
#include "metrics/parity.h"
#include "metrics/verdict.h"
#include "study/guard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace umbrameter {
namespace {

constexpr double kLeastScale = 1e-4;  // below it defaults are perfect, and their noise is no scale
constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

double mean_of(const std::vector<double>& ratios) {
  return std::accumulate(ratios.begin(), ratios.end(), 0.0) / static_cast<double>(ratios.size());
}

Judge::Judge(Studio& studio, std::vector<View> views, Objective objective, const ParameterValues& defaults)
    : studio_(studio), views_(std::move(views)), objective_(objective) {
  std::vector<std::optional<ObjectiveValue>> measures;
  for (const View& view : views_) {
    const Frame frame = studio.render(view, defaults);
    const auto measured = measure_objective(objective, frame.image, view.reference, view.mask, false);
    if (!measured) {
      fail_input(fmt::format("{} has nothing that objective '{}' measures", view.name, name_of(objective)),
                 {}, "choose another objective");
    }
    scales_.push_back(std::max(measured->value, kLeastScale));
    measures.push_back(measured);
  }
  known_[key_of(defaults)] = ratios_of(measures);
}

double Judge::ratio(const ParameterValues& values) {
  return mean_of(ratios(values));
}

/// A difference of squares, which pairs, is the difference of the roots times their sum.
std::optional<Interval> Judge::gain_on(size_t index, const ParameterValues& ours,
                                       const ParameterValues& other) const {
  const View& view = views_[index];
  std::optional<Interval> gain;
  guarded([&] {
    const Image mine = studio_.render(view, ours).image, theirs = studio_.render(view, other).image;
    const auto verdict =
        compare_runs(theirs, mine, view.reference, known_mask(known_mask(view.mask, mine), theirs));
    const auto rmse = [&](const Image& image) {
      return measure_objective(objective_, image, view.reference, view.mask, false).value().value;
    };
    if (!verdict) return;
    const double scale = scales_[index] * std::max(rmse(mine) + rmse(theirs), kLeastScale);
    const Interval& squares = verdict->mse_difference;
    gain = Interval{squares.value / scale, squares.low / scale, squares.high / scale};
  });
  return gain;
}

const std::vector<double>& Judge::ratios(const ParameterValues& values) {
  const auto [place, is_new] = known_.try_emplace(key_of(values));
  if (!is_new) return place->second;
  std::vector<std::optional<ObjectiveValue>> measures(views_.size());
  for (size_t i = 0; i < views_.size(); ++i) {
    measures[i] = measure(i, values, false);
    if (!measures[i]) break;  // what fails on one view is no answer for the others
  }
  return place->second = ratios_of(measures);
}

std::optional<ObjectiveValue> Judge::measure(size_t view, const ParameterValues& values) const {
  return measure(view, values, true);
}

std::optional<ObjectiveValue> Judge::measure(size_t index, const ParameterValues& values,
                                             bool with_interval) const {
  const View& view = views_[index];
  std::optional<ObjectiveValue> measured;
  // Values that a technique's constraints forbid fail here: a wall of the search, not its end.
  guarded([&] {
    const Frame frame = studio_.render(view, values);
    measured = measure_objective(objective_, frame.image, view.reference, view.mask, with_interval);
  });
  return measured;
}

std::vector<double> Judge::ratios_of(const std::vector<std::optional<ObjectiveValue>>& measures) const {
  std::vector<double> all;
  for (size_t i = 0; i < measures.size(); ++i)
    all.push_back(measures[i] ? measures[i]->value / scales_[i] : kNone);
  return all;
}

}  // namespace umbrameter

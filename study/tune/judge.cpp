// SPDX-License-Identifier: Apache-2.0
#include "study/tune/judge.h"

#include "core/error.h"
#include "core/guard.h"
#include "metrics/error/verdict.h"
#include "metrics/image/parity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace umbrameter {
namespace {

constexpr double kLeastScale = 1e-4;  // below it defaults are perfect, and their noise is no scale
constexpr double kNone = std::numeric_limits<double>::infinity();

Numbers numbers_of(const std::optional<ObjectiveValue>& value) {
  if (!value) return std::nullopt;
  if (!value->interval) return std::vector{value->value};
  return std::vector{value->value, value->interval->value, value->interval->low, value->interval->high};
}

std::optional<ObjectiveValue> measure_of(const Numbers& numbers) {
  if (!numbers || numbers->empty()) return std::nullopt;
  ObjectiveValue value = {numbers->front(), {}};
  if (numbers->size() == 4) value.interval = Interval{(*numbers)[1], (*numbers)[2], (*numbers)[3]};
  return value;
}

}  // namespace

double mean_of(const std::vector<double>& ratios) {
  return std::accumulate(ratios.begin(), ratios.end(), 0.0) / static_cast<double>(ratios.size());
}

Judge::Judge(Studio& studio, std::vector<View> views, const Objective& objective,
             const ParameterValues& defaults)
    : studio_(studio), views_(std::move(views)), objective_(objective) {
  Measures found = evaluate(defaults);
  for (size_t i = 0; i < views_.size(); ++i) {
    if (!found[i]) {
      fail_input(
          fmt::format("{} has nothing that objective '{}' measures", views_[i].name, name_of(objective)), {},
          "choose another objective");
    }
    scales_.push_back(std::max(found[i]->value, kLeastScale));
  }
  known_[key_of(defaults)] = std::move(found);
}

double Judge::ratio(const ParameterValues& values) const {
  return mean_of(ratios(values));
}

/// A difference of squares, which pairs, is the difference of the roots times their sum.
std::optional<Interval> Judge::gain_on(size_t index, const ParameterValues& ours,
                                       const ParameterValues& other) const {
  std::optional<Interval> gain;
  if (objective_ != Objective{}) return gain;
  guarded([&] {
    const std::array both = {ours, other};
    const Numbers numbers = studio_.ask(views_[index], both, fmt::format("gain {}", name_of(objective_)),
                                        [&] { return numbers_of(measured_gain(index, ours, other)); });
    if (const auto value = measure_of(numbers)) gain = value->interval;
  });
  return gain;
}

std::optional<ObjectiveValue> Judge::measured_gain(size_t index, const ParameterValues& ours,
                                                   const ParameterValues& other) const {
  const View& view = views_[index];
  const Image mine = studio_.render(view, ours).image, theirs = studio_.render(view, other).image;
  const auto verdict =
      compare_runs(theirs, mine, view.reference, known_mask(known_mask(view.mask, mine), theirs));
  if (!verdict) return std::nullopt;
  const auto rmse = [&](const Image& image) {
    return measure_objective(objective_, image, view.reference, view.mask, false).value().value;
  };
  const double scale = scales_[index] * std::max(rmse(mine) + rmse(theirs), kLeastScale);
  const Interval& squares = verdict->mse_difference;
  const Interval gain = {squares.value / scale, squares.low / scale, squares.high / scale};
  return ObjectiveValue{gain.value, gain};
}

const Judge::Measures& Judge::measures(const ParameterValues& values) const {
  const auto [place, is_new] = known_.try_emplace(key_of(values));
  if (is_new) place->second = render(values);
  return place->second;
}

Judge::Measures Judge::render(const ParameterValues& values) const {
  Measures found(views_.size());
  // Values that a technique's constraints forbid fail here: a wall of the search, not its end. What fails on one view is
  // no answer for the others.
  guarded([&] { found = evaluate(values); });
  return found;
}

Judge::Measures Judge::evaluate(const ParameterValues& values) const {
  const std::vector<Numbers> numbers = studio_.evaluate(
      views_, values, fmt::format("objective {}", name_of(objective_)), true,
      [&](const Image& picture, const View& view) {
        return numbers_of(measure_objective(objective_, picture, view.reference, view.mask, true));
      });
  Measures measures;
  for (const Numbers& one : numbers) measures.push_back(measure_of(one));
  return measures;
}

std::vector<double> Judge::ratios_of(const Measures& measures) const {
  std::vector<double> all;
  for (size_t i = 0; i < measures.size(); ++i)
    all.push_back(measures[i] ? measures[i]->value / scales_[i] : kNone);
  return all;
}

}  // namespace umbrameter

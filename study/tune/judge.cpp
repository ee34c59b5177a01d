#include "study/tune/judge.h"

#include "core/error.h"
#include "metrics/bootstrap.h"
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

bool Judge::is_worse(const ParameterValues& worse, const ParameterValues& better, double least) {
  const std::vector<double> high = ratios(worse), low = ratios(better);
  const double difference = mean_of(high) - mean_of(low);
  if (!(difference > least * std::abs(mean_of(low)))) return false;
  const size_t count = views_.size();
  if (count == 1 || !std::isfinite(difference)) return true;
  double squares = 0.0;
  for (size_t i = 0; i < count; ++i) squares += std::pow(high[i] - low[i] - difference, 2.0);
  const double n = static_cast<double>(count);
  return difference > student_t_975(static_cast<int>(count) - 1) * std::sqrt(squares / (n * (n - 1.0)));
}

std::optional<Interval> Judge::gain(const ParameterValues& ours, const ParameterValues& other) const {
  if (objective_ != Objective::rmse) return std::nullopt;
  double value = 0.0, below = 0.0, above = 0.0;  // the last two squared: views are independent
  for (size_t i = 0; i < views_.size(); ++i) {
    const auto here = gain_on(i, ours, other);
    if (!here) return std::nullopt;
    value += here->value;
    below += std::pow(here->value - here->low, 2.0);
    above += std::pow(here->high - here->value, 2.0);
  }
  const auto count = static_cast<double>(views_.size());
  return Interval{value / count, (value - std::sqrt(below)) / count, (value + std::sqrt(above)) / count};
}

/// A difference of squares, which pairs, is the difference of the roots times their sum.
std::optional<Interval> Judge::gain_on(size_t index, const ParameterValues& ours,
                                       const ParameterValues& other) const {
  const View& view = views_[index];
  std::optional<Interval> gain;
  guarded([&] {
    const Image mine = studio_.render(view, ours).image, theirs = studio_.render(view, other).image;
    const auto verdict = compare_runs(theirs, mine, view.reference, view.mask);
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

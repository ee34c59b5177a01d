// SPDX-License-Identifier: Apache-2.0
#include "study/tune/after_search.h"

#include "core/error.h"
#include "core/guard.h"
#include "core/statistics.h"
#include "metrics/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

double score_on(const Judge& judge, bool is_held_out, Candidate& candidate) {
  const Judge::Measures measures = judge.measures(candidate.values);
  const std::vector<double> ratios = judge.ratios_of(measures);
  for (size_t i = 0; i < ratios.size(); ++i)
    candidate.scores.push_back({judge.views()[i].name, is_held_out, measures[i], ratios[i]});
  return mean_of(ratios);
}

std::vector<double> ratios_in(const Candidate& candidate, bool is_held_out) {
  std::vector<double> ratios;
  for (const ViewScore& score : candidate.scores) {
    if (score.is_held_out == is_held_out) ratios.push_back(score.ratio);
  }
  return ratios;
}

std::optional<double> rise(Judge& judge, ParameterValues values, const std::string& name,
                           const std::optional<ParameterValue>& value, double least) {
  if (!value) return std::nullopt;
  values[name] = *value;
  const double ratio = judge.ratio(values);
  if (!std::isfinite(ratio) || !(least > 0.0)) return std::nullopt;
  return ratio / least - 1.0;
}

/// At the best of the other choices.
std::optional<double> rise_elsewhere(Judge& judge, const TuneTrial& best, const Parameter& axis) {
  std::optional<double> least;
  const int count = level_count(axis);
  for (int i = 0; i < count; ++i) {
    const ParameterValue value = value_at(axis, (i + 0.5) / count);
    if (value == best.values.at(axis.name)) continue;
    const auto here = rise(judge, best.values, axis.name, value, best.objective);
    if (here && (!least || *here < *least)) least = here;
  }
  return least;
}

size_t grid_levels(const Parameter& axis, int steps) {
  const int levels = level_count(axis);
  if (!is_ordered(axis)) return static_cast<size_t>(levels);
  return static_cast<size_t>(levels > 0 ? std::min(levels, steps) : steps);
}

double grid_position(const Parameter& axis, size_t level, size_t count) {
  if (!is_ordered(axis)) return (static_cast<double>(level) + 0.5) / static_cast<double>(count);
  return count > 1 ? static_cast<double>(level) / static_cast<double>(count - 1) : 0.0;
}

}  // namespace

void score_candidate(const Judge& trained, const Judge* held_out, Candidate& candidate) {
  candidate.ratio = score_on(trained, false, candidate);
  if (held_out != nullptr) candidate.held_out_ratio = score_on(*held_out, true, candidate);
}

std::optional<Interval> gain_over(const Judge& judge, bool is_held_out, const Candidate& tuned,
                                  const Candidate& candidate) {
  if (judge.views().size() == 1) return judge.gain_on(0, tuned.values, candidate.values);
  std::vector<double> gains = ratios_in(candidate, is_held_out);
  const std::vector<double> ours = ratios_in(tuned, is_held_out);
  for (size_t i = 0; i < gains.size(); ++i) gains[i] -= ours[i];
  const double mean = mean_of(gains);
  if (!std::isfinite(mean)) return std::nullopt;
  double squares = 0.0;
  for (const double gain : gains) squares += (gain - mean) * (gain - mean);
  const auto n = static_cast<double>(gains.size());
  const double half =
      student_t_975(static_cast<int>(gains.size()) - 1) * std::sqrt(squares / (n * (n - 1.0)));
  return Interval{mean, mean - half, mean + half};
}

std::vector<Sensitivity> measure_sensitivities(Judge& judge, const SearchSpace& space,
                                               const IsActive& is_active, const SearchResult& search,
                                               const GoesOn& goes_on) {
  std::vector<Sensitivity> all;
  const TuneTrial& best = search.best;
  for (size_t i = 0; i < space.size() && goes_on(); ++i) {
    const Parameter& axis = space[i];
    if (is_active && !is_active(axis, best.values)) continue;
    Sensitivity one{axis.name, {}, {}, search.effects[i].relative_spread};
    if (is_ordered(axis)) {
      const ParameterValue& value = best.values.at(axis.name);
      one.rise_below = rise(judge, best.values, axis.name, neighbour(axis, value, -1), best.objective);
      one.rise_above = rise(judge, best.values, axis.name, neighbour(axis, value, 1), best.objective);
    } else {
      one.rise_above = rise_elsewhere(judge, best, axis);
    }
    all.push_back(one);
  }
  return all;
}

GridCheck check_grid(Judge& judge, const SearchSpace& space, const IsActive& is_active,
                     const ParameterValues& base, int steps) {
  size_t count = 1;
  for (const Parameter& axis : space) {
    count *= grid_levels(axis, steps);
    if (count > kMaxGridPoints) {
      fail_input(fmt::format("a grid of {} steps over {} parameters has more than {} points", steps,
                             space.size(), kMaxGridPoints),
                 {}, "name fewer with --parameters");
    }
  }
  GridCheck check{count, std::numeric_limits<double>::infinity(), {}};
  for (size_t index = 0; index < count; ++index) {
    Point point;
    size_t rest = index;
    for (const Parameter& axis : space) {
      const size_t levels = grid_levels(axis, steps);
      point.push_back(grid_position(axis, rest % levels, levels));
      rest /= levels;
    }
    const ParameterValues values = without_inactive(space, is_active, values_at(space, point, base), base);
    const double ratio = judge.ratio(values);
    if (!(ratio < check.best_ratio)) continue;
    check.best_ratio = ratio;
    check.best = values;
  }
  return check;
}

}  // namespace umbrameter

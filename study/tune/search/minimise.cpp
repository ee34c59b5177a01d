// SPDX-License-Identifier: Apache-2.0
#include "study/tune/search/minimise.h"

#include "study/tune/search/local_search.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace umbrameter {
namespace {

constexpr int kCoarseLevels = 5;      // tried of a number that matters
constexpr double kMatters = 2e-3;     // relative spread from which an axis is searched further
constexpr size_t kMostAxes = 6;       // searched together; the others one by one
constexpr double kFirstStep = 0.125;  // half of a coarse level
constexpr double kLastStep = 0.004;
constexpr double kStepShrink = 0.4;
constexpr size_t kModelPerAxis = 10;   // evaluations of a quadratic model, which begins with 2 an axis and 1
constexpr size_t kGlobalPerAxis = 12;  // evaluations that make a global search worth while
constexpr double kNearlyAsGood = 1.5;  // a choice this good may become best with other numbers

std::vector<double> coarse_positions(const Parameter& axis) {
  const int levels = level_count(axis);
  const bool tries_all = !is_ordered(axis) || (levels > 0 && levels <= kCoarseLevels);
  const int count = tries_all ? levels : kCoarseLevels;
  std::vector<double> positions;
  for (int i = 0; i < count; ++i)
    positions.push_back(is_ordered(axis) ? static_cast<double>(i) / std::max(count - 1, 1)
                                         : (i + 0.5) / count);
  return positions;
}

/// Those that every axis gets before any gets them all: all of a choice, the second and the fourth of a number.
std::vector<double> first_positions(const Parameter& axis) {
  const std::vector<double> all = coarse_positions(axis);
  if (!is_ordered(axis) || all.size() < kCoarseLevels) return all;
  return {all[1], all[all.size() - 2]};
}

/// Tries levels of an axis from the best trial; the spread of what is finite over the best.
void screen(Trials& trials, size_t axis, const std::vector<double>& positions, AxisEffect& effect) {
  effect.is_active = trials.is_active(axis);
  if (!effect.is_active) return;
  const TuneTrial start = trials.best();
  double low = start.objective, high = start.objective;
  std::set<ParameterValue> measured{value_at(trials.space()[axis], start.point[axis])};
  for (const double position : positions) {
    Point point = start.point;
    point[axis] = position;
    const double objective = trials.at(point);
    if (!std::isfinite(objective)) continue;
    measured.insert(value_at(trials.space()[axis], position));
    low = std::min(low, objective);
    high = std::max(high, objective);
  }
  const double spread = (high - low) / std::max(std::abs(trials.best().objective), 1e-12);
  effect.relative_spread = std::max(effect.relative_spread, spread);
  effect.values = std::max(effect.values, measured.size());
}

/// Numbers that matter, the strongest first.
std::vector<size_t> strongest(const SearchSpace& space, const std::vector<AxisEffect>& effects) {
  std::vector<size_t> axes;
  for (size_t i = 0; i < space.size(); ++i) {
    if (is_ordered(space[i]) && effects[i].relative_spread >= kMatters) axes.push_back(i);
  }
  std::ranges::stable_sort(axes, std::greater<>{}, [&](size_t i) { return effects[i].relative_spread; });
  return axes;
}

/// The strongest number, or all where none matters: a map that lost its casters is the same with every bias, and another
/// choice brings them back.
std::vector<size_t> numbers_to_move(const SearchSpace& space, const std::vector<size_t>& numbers) {
  if (!numbers.empty()) return {numbers.front()};
  std::vector<size_t> all;
  for (size_t i = 0; i < space.size(); ++i) {
    if (is_ordered(space[i])) all.push_back(i);
  }
  return all;
}

/// Every choice once more at the present numbers; a promising one with numbers moved, too.
void search_choices(Trials& trials, const std::vector<size_t>& numbers) {
  const SearchSpace& space = trials.space();
  const std::vector<size_t> moving = numbers_to_move(space, numbers);
  for (size_t axis = 0; axis < space.size(); ++axis) {
    if (is_ordered(space[axis])) continue;
    const TuneTrial start = trials.best();
    for (const double position : coarse_positions(space[axis])) {
      Point point = start.point;
      point[axis] = position;
      const double objective = trials.at(point);
      if (!(objective < kNearlyAsGood * start.objective)) continue;
      if (values_at(space, point, {}) == values_at(space, start.point, {})) continue;
      for (const size_t number : moving) {
        for (const double step : {-kFirstStep, kFirstStep}) {
          Point moved = point;
          moved[number] = std::clamp(moved[number] + step, 0.0, 1.0);
          trials.at(moved);
        }
      }
    }
  }
}

class Search {
 public:
  explicit Search(Trials& trials) : trials_(trials) {
    for (const Parameter& axis : trials.space()) effects_.push_back({axis.name, 0.0, 0});
  }

  void know(std::span<const AxisEffect> effects) {
    effects_.assign(effects.begin(), effects.end());
    numbers_ = strongest(trials_.space(), effects_);
  }

  /// A few levels of every axis; then all of those numbers that matter, the strongest first.
  void screen_all() {
    const SearchSpace& space = trials_.space();
    for (const bool numbers : {false, true}) {  // choices first: they say which numbers act
      for (size_t i = 0; i < space.size(); ++i) {
        if (is_ordered(space[i]) == numbers) screen(trials_, i, first_positions(space[i]), effects_[i]);
      }
    }
    for (const size_t i : strongest(space, effects_))
      screen(trials_, i, coarse_positions(space[i]), effects_[i]);
    numbers_ = strongest(space, effects_);
  }

  void search_wide() {
    const std::span<const size_t> together = first(numbers_);
    const size_t share = trials_.left() / 4;
    if (!together.empty() && share >= kGlobalPerAxis * together.size())
      search_globally(trials_, together, share);
  }

  /// True when nothing is left to improve at the smallest step.
  bool refine() {
    for (double step = kFirstStep; step >= kLastStep; step *= kStepShrink) {
      const Point before = trials_.best().point;
      search_smoothly(trials_, first(numbers_), step, kModelPerAxis * first(numbers_).size());
      for (const size_t axis : numbers_) search_line(trials_, axis, step);
      if (step == kFirstStep) {
        search_choices(trials_, numbers_);
        if (choices_changed(before)) screen_all();
      }
      if (trials_.is_over()) return false;
    }
    search_robustly(trials_, first(numbers_), kFirstStep, 12 * numbers_.size());
    return !trials_.is_over();
  }

  std::vector<AxisEffect> take_effects() { return std::move(effects_); }

 private:
  static std::span<const size_t> first(const std::vector<size_t>& axes) {
    return std::span(axes).first(std::min(axes.size(), kMostAxes));
  }

  bool choices_changed(const Point& before) const {
    for (size_t i = 0; i < before.size(); ++i) {
      const Parameter& axis = trials_.space()[i];
      if (!is_ordered(axis) && value_at(axis, before[i]) != value_at(axis, trials_.best().point[i]))
        return true;
    }
    return false;
  }

  Trials& trials_;
  std::vector<AxisEffect> effects_;
  std::vector<size_t> numbers_;
};

constexpr double kWorthAnotherRound = 1e-3;  // relative improvement

}  // namespace

SearchResult minimise(const SearchSpace& space, std::span<const ParameterValues> starts,
                      const ParameterValues& base, const ObjectiveFunction& objective,
                      const SearchBudget& budget, const IsActive& is_active,
                      std::span<const AxisEffect> known_effects) {
  Trials trials(space, base, objective, budget, is_active);
  for (const ParameterValues& start : starts) trials.at(point_of(space, start));
  if (trials.all().empty() || !std::isfinite(trials.best().objective))
    fail_input("the objective cannot be measured where the search starts");
  Search search(trials);
  if (known_effects.empty()) {
    search.screen_all();
    search.search_wide();
  } else {
    search.know(known_effects);
  }
  bool is_converged = false;
  for (double last = std::numeric_limits<double>::infinity(); !is_converged;) {
    if (!search.refine()) break;
    const double least = trials.best().objective;
    is_converged = !(last - least > kWorthAnotherRound * std::abs(least));
    last = least;
  }
  return {trials.all(), trials.best(), search.take_effects(), is_converged};
}

}  // namespace umbrameter

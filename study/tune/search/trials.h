// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a search has tried: every point once, within a budget. Not here: where it looks next (study/tune/search/minimise.h).

#include "results/tune/tuning.h"
#include "study/tune/search/search_space.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace umbrameter {

/// The number to make small; infinite where there is none (the values are not allowed, or the run failed).
using ObjectiveFunction = std::function<double(const ParameterValues&)>;

struct SearchBudget {
  size_t evaluations = 0;
  std::function<bool()> is_time_up;  // asked before each evaluation
};

class Trials {
 public:
  Trials(const SearchSpace& space, const ParameterValues& base, const ObjectiveFunction& objective,
         const SearchBudget& budget, const IsActive& is_active = {});

  /// The objective there, from memory if any point of the same picture was tried: one of the same values, but for those that
  /// do not act. Infinite once the budget is spent, but
  /// never for the first.
  double at(const Point& point);

  bool is_over() const;
  size_t left() const { return budget_.evaluations - std::min(budget_.evaluations, all_.size()); }
  const std::vector<TuneTrial>& all() const { return all_; }  // in the order they were evaluated
  /// The least objective so far; the first trial while none is finite. Needs one trial.
  const TuneTrial& best() const { return all_[best_]; }
  const SearchSpace& space() const { return space_; }
  /// Whether the axis acts beside the values of the best trial.
  bool is_active(size_t axis) const;

 private:
  const SearchSpace& space_;
  const ParameterValues& base_;
  const ObjectiveFunction& objective_;
  const SearchBudget& budget_;
  IsActive is_active_;
  std::vector<TuneTrial> all_;
  std::map<std::string, size_t> known_;
  size_t best_ = 0;
};

/// Equal for equal values.
std::string key_of(const ParameterValues& values);

/// Values of the `count` trials of least objective, or of all; of equal ones the first tried.
std::vector<ParameterValues> best_values(const std::vector<TuneTrial>& trials, size_t count);

}  // namespace umbrameter

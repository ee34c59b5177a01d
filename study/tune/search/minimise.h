// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search: a few levels of every axis, more of those that matter, then NLopt's global and local methods on the axes that matter, then each
// axis by itself. Needs no gradients: near the onset of acne an objective is a step.

#include "study/tune/search/trials.h"

#include <span>
#include <vector>

namespace umbrameter {

/// How much an axis moves the objective: the spread of its coarse levels over the best objective when they were tried.
struct AxisEffect {
  std::string parameter;
  double relative_spread = 0.0;
  size_t values = 0;      // that were measured, the start's among them; 0: the budget ended before
  bool is_active = true;  // false: it never acted beside the best values, and cost nothing
};

struct SearchResult {
  std::vector<TuneTrial> trials;  // in the order they were evaluated
  TuneTrial best;
  std::vector<AxisEffect> effects;  // in the order of the axes
  bool is_converged = false;        // else the budget ended it
};

/// The least `objective` found. `starts` (at least one) are tried first, then the search goes on from the best of them.
/// With `known_effects`, of a search of a similar objective, the coarse levels and the global search are left out. The same
/// arguments try the same points. Error{input} when no start has a finite objective.
SearchResult minimise(const SearchSpace& space, std::span<const ParameterValues> starts,
                      const ParameterValues& base, const ObjectiveFunction& objective,
                      const SearchBudget& budget, const IsActive& is_active = {},
                      std::span<const AxisEffect> known_effects = {});

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is asked about the best values once they are found.

#include "study/tune/judge.h"
#include "study/tune/tune.h"
#include "study/tune/windows.h"

#include <vector>

namespace umbrameter {

/// Sets scores and ratios on the judges' views; `held_out` may be null.
void score_candidate(const Judge& trained, const Judge* held_out, Candidate& candidate);

/// `candidate.gain` or `held_out_gain`, of two candidates scored by `judge`.
std::optional<Interval> gain_over(const Judge& judge, bool is_held_out, const Candidate& tuned,
                                  const Candidate& candidate);

/// One step from `best` on every axis that acts; axes from where the time is up are left out.
std::vector<Sensitivity> measure_sensitivities(Judge& judge, const SearchSpace& space,
                                               const IsActive& is_active, const SearchResult& search,
                                               const GoesOn& goes_on);

/// Every point of a grid of `steps` a number and all choices. Error{input} for more than kMaxGridPoints.
inline constexpr size_t kMaxGridPoints = 20000;
GridCheck check_grid(Judge& judge, const SearchSpace& space, const IsActive& is_active,
                     const ParameterValues& base, int steps);

}  // namespace umbrameter

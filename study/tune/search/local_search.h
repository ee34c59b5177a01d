// SPDX-License-Identifier: Apache-2.0
#pragma once
// Steps of the search on some of the axes, the others as in the best trial.

#include "study/tune/search/trials.h"

#include <span>

namespace umbrameter {

/// NLopt's DIRECT-L over the whole of the axes, at most `evaluations` new points.
void search_globally(Trials& trials, std::span<const size_t> axes, size_t evaluations);

/// NLopt's BOBYQA from the best trial: a quadratic model, quick where the objective is smooth.
void search_smoothly(Trials& trials, std::span<const size_t> axes, double first_step, size_t evaluations);

/// NLopt's Sbplx from the best trial: simplices on subspaces, slow and hard to mislead.
void search_robustly(Trials& trials, std::span<const size_t> axes, double first_step, size_t evaluations);

/// One axis: both sides of the best trial at `step` and the parabola's minimum; goes on while it improves.
void search_line(Trials& trials, size_t axis, double step);

}  // namespace umbrameter

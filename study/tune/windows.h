// SPDX-License-Identifier: Apache-2.0
#pragma once
// The safe windows of the tuned parameters that have one (study/tune/safe_window.h), measured on a judge's views.

#include "study/tune/judge.h"
#include "study/tune/safe_window.h"

#include <functional>
#include <span>
#include <vector>

namespace umbrameter {

using GoesOn = std::function<bool()>;

/// One window a tuned parameter that has one, the other values as in `values`. Faults are the worst over views. Parameters
/// that do not act are left out. `before`: those found beside other values, where each begins.
std::vector<SafeWindow> find_windows(Studio& studio, const Judge& judge, const SearchSpace& space,
                                     const IsActive& is_active, const Objective& objective,
                                     const ParameterValues& values, const GoesOn& goes_on,
                                     std::span<const SafeWindow> before = {});

/// Median width of a texel on the scored receivers of a view; 0 when not known.
double median_texel_world(Studio& studio, const View& view, const ParameterValues& values);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far a parameter may be moved: a bias from where it has no acne to where it detaches shadows, a light size from where
// penumbrae are not too hard to where they are too soft. An empty window is a finding: no value works there.

#include "results/tune/tuning.h"
#include "study/tune/search/search_space.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Engines have biases that begin below 0: those move shadows away as they fall.
bool falls(const Parameter& bias);

/// The window that is asked for a tuned parameter; absent for most.
std::optional<WindowKind> window_of(const Parameter& parameter);

/// Absent measures: the run failed there, or there is nothing to measure.
using MeasureWindow = std::function<std::optional<WindowPoint>(double value)>;

/// Steps up the axis, to the first value that is too high and not too low, then bisection of both ends: what looks like acne
/// on shadows that are detached or moved aside bounds nothing. `goes_on` is asked before each measurement. With a window that
/// was found beside other values its ends are asked first, with their neighbours beyond and the middle: where they still
/// hold, that is all.
SafeWindow find_window(const Parameter& axis, const MeasureWindow& measure,
                       const std::function<bool()>& goes_on, const SafeWindow* before = nullptr);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far a parameter may be moved: a bias from where it has no acne to where it detaches shadows, a light size from where
// penumbrae are not too hard to where they are too soft. An empty window is a finding: no value works there.

#include "study/tune/objective.h"
#include "study/tune/search/search_space.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

enum class WindowKind : uint8_t {
  bias,  // of group "bias": a length in texels or world units, or an engine's in its own; faults: shares of acne and of peter-panning
  light_size  // of group "light"; faults: octaves by which the median penumbra is too narrow and too wide
};

/// Engines have biases that begin below 0: those move shadows away as they fall.
bool falls(const Parameter& bias);

/// The window that is asked for a tuned parameter; absent for most.
std::optional<WindowKind> window_of(const Parameter& parameter);

/// Most of a fault within a window: a share of the scored pixels, or octaves (a quarter: 19 % of the width).
double tolerance_of(WindowKind kind);

struct WindowPoint {
  double value = 0.0;
  double objective = 0.0;
  double too_low = 0.0, too_high = 0.0;  // faults of a value that is too low, and of one that is too high
};

/// Absent measures: the run failed there, or there is nothing to measure.
using MeasureWindow = std::function<std::optional<WindowPoint>(double value)>;

struct SafeWindow {
  std::string parameter;
  std::string unit;
  WindowKind kind = WindowKind::bias;
  bool falls = false;               // a bias that moves shadows away as it falls
  bool is_at_tuned = false;         // else: beside the values as given
  std::vector<WindowPoint> points;  // by value
  std::optional<double> from;       // least value from which on none of them is too low; absent: all are
  std::optional<double> to;         // largest value up to which none is too high; absent: all are
  bool is_complete = true;          // false: the time was up, and there is no window

  bool has_window() const { return from && to && *from <= *to; }
};

/// A length in the one unit and in the other; absent when it is no length or the texel is not known.
std::optional<double> in_texels(const std::string& unit, double length, double texel_world);
std::optional<double> in_world_units(const std::string& unit, double length, double texel_world);

/// Steps up the axis, to the first value that is too high and not too low, then bisection of both ends: what looks like acne
/// on shadows that are detached or moved aside bounds nothing. `goes_on` is asked before each measurement. With a window that
/// was found beside other values its ends are asked first, with their neighbours beyond and the middle: where they still
/// hold, that is all.
SafeWindow find_window(const Parameter& axis, const MeasureWindow& measure,
                       const std::function<bool()>& goes_on, const SafeWindow* before = nullptr);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "study/tune/windows.h"

#include "core/statistics.h"
#include "results/guard.h"
#include "study/tune/draw_and_score.h"

#include <algorithm>

namespace umbrameter {
namespace {

/// What one picture says of a value: its faults, or nothing where there is nothing to measure.
struct ValueFaults {
  double too_low = 0.0, too_high = 0.0;
};

std::optional<ValueFaults> faults_of(WindowKind kind, bool falls, const Image& test, const View& view) {
  if (kind == WindowKind::bias) {
    const FaultShares shares = measure_fault_shares(test, view.reference, view.mask);
    if (falls) return ValueFaults{shares.peter_panning, shares.acne};
    return ValueFaults{shares.acne, shares.peter_panning};
  }
  const auto octaves = measure_width_octaves(test, view.reference, view.mask);
  if (!octaves) return std::nullopt;
  return ValueFaults{std::max(0.0, -*octaves), std::max(0.0, *octaves)};
}

class WindowMeasure {
 public:
  WindowMeasure(Studio& studio, const Judge& judge, Objective objective, WindowKind kind, bool falls)
      : studio_(studio), judge_(judge), objective_(objective), kind_(kind), falls_(falls) {}

  std::optional<WindowPoint> at(const ParameterValues& values, double value) const {
    WindowPoint point{value, 0.0, 0.0, 0.0};
    size_t measured = 0;
    const std::vector<View>& views = judge_.views();
    const auto failure = guarded([&] {
      draw_and_score(
          views.size(), [&](size_t i) { return studio_.render(views[i], values); },
          [&](size_t i, const Frame& frame) {
            if (add(frame.image, views[i], point)) ++measured;
            return true;
          });
    });
    if (failure || measured == 0) return std::nullopt;
    point.objective /= static_cast<double>(measured);
    return point;
  }

 private:
  bool add(const Image& test, const View& view, WindowPoint& point) const {
    const auto objective = measure_objective(objective_, test, view.reference, view.mask, false);
    const auto faults = faults_of(kind_, falls_, test, view);
    if (!objective || !faults) return false;
    point.objective += objective->value;
    point.too_low = std::max(point.too_low, faults->too_low);
    point.too_high = std::max(point.too_high, faults->too_high);
    return true;
  }

  Studio& studio_;
  const Judge& judge_;
  Objective objective_;
  WindowKind kind_;
  bool falls_;
};

}  // namespace

double median_texel_world(Studio& studio, const View& view, const ParameterValues& values) {
  const Frame frame = studio.render(view, values);
  if (!frame.image.has("texel_world")) return 0.0;
  std::vector<double> widths;
  const auto plane = frame.image.plane("texel_world");
  for (size_t i = 0; i < plane.size(); ++i) {
    if (view.mask[i] != 0 && plane[i] > 0.0f) widths.push_back(static_cast<double>(plane[i]));
  }
  return median_if_any(std::move(widths)).value_or(0.0);
}

std::vector<SafeWindow> find_windows(Studio& studio, const Judge& judge, const SearchSpace& space,
                                     const IsActive& is_active, Objective objective,
                                     const ParameterValues& values, const GoesOn& goes_on,
                                     std::span<const SafeWindow> before) {
  std::vector<SafeWindow> windows;
  for (const Parameter& axis : space) {
    const auto kind = window_of(axis);
    if (!kind || (is_active && !is_active(axis, values))) continue;
    const WindowMeasure measure(studio, judge, objective, *kind, falls(axis));
    const auto at = [&](double value) {
      ParameterValues moved = values;
      moved[axis.name] = value;
      return measure.at(moved, value);
    };
    const auto known = std::ranges::find(before, axis.name, &SafeWindow::parameter);
    windows.push_back(find_window(axis, at, goes_on, known == before.end() ? nullptr : &*known));
  }
  return windows;
}

}  // namespace umbrameter

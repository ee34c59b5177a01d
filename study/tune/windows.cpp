// SPDX-License-Identifier: Apache-2.0
#include "study/tune/windows.h"

#include "core/guard.h"
#include "core/statistics.h"

#include <fmt/format.h>

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
  WindowMeasure(Studio& studio, const Judge& judge, const Objective& objective, WindowKind kind, bool falls)
      : studio_(studio), judge_(judge), objective_(objective), kind_(kind), falls_(falls) {}

  std::optional<WindowPoint> at(const ParameterValues& values, double value) const {
    std::vector<Numbers> measured;
    const auto failure = guarded([&] {
      measured =
          studio_.evaluate(judge_.views(), values, what(), false,
                           [&](const Image& test, const View& view) { return numbers_of(test, view); });
    });
    if (failure) return std::nullopt;
    WindowPoint point{value, 0.0, 0.0, 0.0};
    double count = 0.0;
    for (const Numbers& numbers : measured) {
      if (!numbers || numbers->size() != 3) continue;
      point.objective += (*numbers)[0];
      point.too_low = std::max(point.too_low, (*numbers)[1]);
      point.too_high = std::max(point.too_high, (*numbers)[2]);
      count += 1.0;
    }
    if (count == 0.0) return std::nullopt;
    point.objective /= count;
    return point;
  }

 private:
  std::string what() const {
    const char* const kind = kind_ == WindowKind::bias ? "bias" : "light size";
    return fmt::format("window of {}{}, {}", kind, falls_ ? ", falling" : "", name_of(objective_));
  }

  /// The objective, and what is too low and too high.
  Numbers numbers_of(const Image& test, const View& view) const {
    const auto objective = measure_objective(objective_, test, view.reference, view.mask, false);
    const auto faults = faults_of(kind_, falls_, test, view);
    if (!objective || !faults) return std::nullopt;
    return std::vector{objective->value, faults->too_low, faults->too_high};
  }

  Studio& studio_;
  const Judge& judge_;
  Objective objective_;
  WindowKind kind_;
  bool falls_;
};

}  // namespace

double median_texel_world(Studio& studio, const View& view, const ParameterValues& values) {
  const auto measure = [&]() -> Numbers {
    const Frame frame = studio.render(view, values);
    if (!frame.image.has("texel_world")) return std::nullopt;
    std::vector<double> widths;
    const auto plane = frame.image.plane("texel_world");
    for (size_t i = 0; i < plane.size(); ++i) {
      if (view.mask[i] != 0 && plane[i] > 0.0f) widths.push_back(static_cast<double>(plane[i]));
    }
    return std::vector{median_if_any(std::move(widths)).value_or(0.0)};
  };
  const Numbers median = studio.ask(view, {&values, 1}, "median texel", measure);
  return median ? median->at(0) : 0.0;
}

std::vector<SafeWindow> find_windows(Studio& studio, const Judge& judge, const SearchSpace& space,
                                     const IsActive& is_active, const Objective& objective,
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

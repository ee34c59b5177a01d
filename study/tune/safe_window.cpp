// SPDX-License-Identifier: Apache-2.0
#include "study/tune/safe_window.h"

#include <algorithm>
#include <set>

namespace umbrameter {
namespace {

constexpr int kSteps = 7;
constexpr int kBisections = 4;

/// Beyond such a value everything is too high, whatever else it looks like.
bool is_only_too_high(const WindowPoint& point, double tolerance) {
  return point.too_high > tolerance && !(point.too_low > tolerance);
}

/// The least value from which on no point is too low.
std::optional<double> lower_end(const std::vector<WindowPoint>& points, double tolerance) {
  std::optional<double> from;
  for (auto point = points.rbegin(); point != points.rend() && !(point->too_low > tolerance); ++point)
    from = point->value;
  return from;
}

/// The largest value up to which no point is too high.
std::optional<double> upper_end(const std::vector<WindowPoint>& points, double tolerance) {
  std::optional<double> to;
  for (auto point = points.begin(); point != points.end() && !(point->too_high > tolerance); ++point)
    to = point->value;
  return to;
}

class Sweep {
 public:
  Sweep(const Parameter& axis, const MeasureWindow& measure, const std::function<bool()>& goes_on)
      : axis_(axis), measure_(measure), goes_on_(goes_on) {}

  bool add(double position) { return add_value(std::get<double>(value_at(axis_, position))); }

  bool add_value(double value) {
    if (!goes_on_()) return false;
    if (!tried_.insert(value).second) return true;
    if (const auto point = measure_(value)) points.push_back(*point);
    std::ranges::sort(points, {}, &WindowPoint::value);
    return true;
  }

  /// The ends of a window, what was tried next beyond them, and its middle.
  bool add_ends(const SafeWindow& before) {
    const double middle = 0.5 * (position_of(axis_, *before.from) + position_of(axis_, *before.to));
    const auto is_at = [](double value) {
      return [value](const WindowPoint& p) { return p.value == value; };
    };
    const auto from = std::ranges::find_if(before.points, is_at(*before.from));
    const auto to = std::ranges::find_if(before.points, is_at(*before.to));
    const bool has_below = from != before.points.begin(), has_above = to + 1 != before.points.end();
    return add_value(from->value) && add_value(to->value) && add(middle) &&
           (!has_below || add_value((from - 1)->value)) && (!has_above || add_value((to + 1)->value));
  }

  bool has_ends(const SafeWindow& window, double tolerance) const {
    return lower_end(points, tolerance) == window.from && upper_end(points, tolerance) == window.to;
  }

  /// Upwards, to the first value that is too high and not too low.
  bool add_levels(double tolerance) {
    for (int i = 0; i <= kSteps; ++i) {
      const double value = std::get<double>(value_at(axis_, static_cast<double>(i) / kSteps));
      if (!add_value(value)) return false;
      const auto point = std::ranges::find(points, value, &WindowPoint::value);
      if (point == points.end() || !is_only_too_high(*point, tolerance)) continue;
      points.erase(point + 1, points.end());
      return true;
    }
    return true;
  }

  /// Between the end and its neighbour beyond.
  bool refine(std::optional<double> (*end)(const std::vector<WindowPoint>&, double), double tolerance,
              bool towards_less) {
    for (int i = 0; i < kBisections; ++i) {
      const auto value = end(points, tolerance);
      if (!value) return true;
      auto place = std::ranges::find(points, *value, &WindowPoint::value);
      if (towards_less ? place == points.begin() : place + 1 == points.end()) return true;
      const auto next = towards_less ? place - 1 : place + 1;
      if (!add(0.5 * (position_of(axis_, place->value) + position_of(axis_, next->value)))) return false;
    }
    return true;
  }

  std::vector<WindowPoint> points;

 private:
  std::set<double> tried_;
  const Parameter& axis_;
  const MeasureWindow& measure_;
  const std::function<bool()>& goes_on_;
};

}  // namespace

bool falls(const Parameter& bias) {
  return bias.group == "bias" && bias.min < 0.0;
}

std::optional<WindowKind> window_of(const Parameter& parameter) {
  if (parameter.type != ParameterType::real) return std::nullopt;
  if (parameter.group == "light") return WindowKind::light_size;
  const bool is_length = parameter.unit == "texels" || parameter.unit == "world";
  const bool is_of_engine = parameter.stage == ParameterStage::host;
  return parameter.group == "bias" && (is_length || is_of_engine) ? std::optional(WindowKind::bias)
                                                                  : std::nullopt;
}

SafeWindow find_window(const Parameter& axis, const MeasureWindow& measure,
                       const std::function<bool()>& goes_on, const SafeWindow* before) {
  Sweep sweep(axis, measure, goes_on);
  SafeWindow out;
  out.parameter = axis.name;
  out.unit = axis.unit;
  out.kind = window_of(axis).value_or(WindowKind::bias);
  out.falls = falls(axis);
  const double tolerance = tolerance_of(out.kind);
  const bool is_known = before != nullptr && before->has_window();
  out.is_complete = !is_known || sweep.add_ends(*before);
  if (out.is_complete && !(is_known && sweep.has_ends(*before, tolerance)))
    out.is_complete = sweep.add_levels(tolerance) && sweep.refine(lower_end, tolerance, true) &&
                      sweep.refine(upper_end, tolerance, false);
  out.points = std::move(sweep.points);
  if (!out.is_complete) return out;
  out.from = lower_end(out.points, tolerance);
  out.to = upper_end(out.points, tolerance);
  return out;
}

}  // namespace umbrameter

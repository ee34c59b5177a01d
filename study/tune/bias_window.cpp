// SPDX-License-Identifier: Apache-2.0
#include "study/tune/bias_window.h"

#include <algorithm>

namespace umbrameter {
namespace {

constexpr int kSteps = 14;
constexpr int kBisections = 3;

bool has_acne(const BiasPoint& point) {
  return point.shares.acne > kWindowTolerance;
}

bool has_peter_panning(const BiasPoint& point) {
  return point.shares.peter_panning > kWindowTolerance;
}

/// The least bias from which on no point has acne.
std::optional<double> acne_free_from(const std::vector<BiasPoint>& points) {
  std::optional<double> from;
  for (auto point = points.rbegin(); point != points.rend() && !has_acne(*point); ++point) from = point->bias;
  return from;
}

/// The largest bias up to which no point has peter-panning.
std::optional<double> peter_pan_free_to(const std::vector<BiasPoint>& points) {
  std::optional<double> to;
  for (auto point = points.begin(); point != points.end() && !has_peter_panning(*point); ++point)
    to = point->bias;
  return to;
}

class Sweep {
 public:
  Sweep(const Parameter& axis, const MeasureBias& measure, const std::function<bool()>& goes_on)
      : axis_(axis), measure_(measure), goes_on_(goes_on) {}

  bool add(double position) {
    if (!goes_on_()) return false;
    const double bias = std::get<double>(value_at(axis_, position));
    const auto same = [&](const BiasPoint& point) { return point.bias == bias; };
    if (std::ranges::any_of(points, same)) return true;
    if (const auto point = measure_(bias)) points.push_back(*point);
    std::ranges::sort(points, {}, &BiasPoint::bias);
    return true;
  }

  bool add_all() {
    for (int i = 0; i <= kSteps; ++i) {
      if (!add(static_cast<double>(i) / kSteps)) return false;
    }
    return true;
  }

  /// Between the bias and its neighbour on the other side of the border.
  bool refine(std::optional<double> (*border)(const std::vector<BiasPoint>&), bool towards_less) {
    for (int i = 0; i < kBisections; ++i) {
      const auto bias = border(points);
      if (!bias) return true;
      auto place = std::ranges::find(points, *bias, &BiasPoint::bias);
      if (towards_less ? place == points.begin() : place + 1 == points.end()) return true;
      const auto next = towards_less ? place - 1 : place + 1;
      if (!add(0.5 * (position_of(axis_, place->bias) + position_of(axis_, next->bias)))) return false;
    }
    return true;
  }

  std::vector<BiasPoint> points;

 private:
  const Parameter& axis_;
  const MeasureBias& measure_;
  const std::function<bool()>& goes_on_;
};

std::optional<double> ratio(double a, double b) {
  return b > 0.0 ? std::optional(a / b) : std::nullopt;
}

}  // namespace

bool is_bias_length(const Parameter& parameter) {
  return parameter.type == ParameterType::real && parameter.group == "bias" &&
         (parameter.unit == "texels" || parameter.unit == "world");
}

std::optional<double> BiasSweep::texels(double bias) const {
  return unit == "texels" ? std::optional(bias) : ratio(bias, texel_world);
}

std::optional<double> BiasSweep::world(double bias) const {
  if (unit == "world") return bias;
  return texel_world > 0.0 ? std::optional(bias * texel_world) : std::nullopt;
}

BiasSweep sweep_bias(const Parameter& axis, const MeasureBias& measure,
                     const std::function<bool()>& goes_on) {
  Sweep sweep(axis, measure, goes_on);
  BiasSweep out;
  out.parameter = axis.name;
  out.unit = axis.unit;
  out.is_complete =
      sweep.add_all() && sweep.refine(acne_free_from, true) && sweep.refine(peter_pan_free_to, false);
  out.points = std::move(sweep.points);
  if (!out.is_complete) return out;
  out.acne_free_from = acne_free_from(out.points);
  out.peter_pan_free_to = peter_pan_free_to(out.points);
  return out;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "study/tune/search/search_space.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, 4> kCostUnits{"taps", "samples", "count", "px"};
// Lengths and scales that start at 0 span orders of magnitude: half way is an eighth of the range. World units reach
// from a texel of a close-up to the scene's size: half way is a 32nd.
constexpr double kPowerFromZero = 3.0, kPowerOfWorld = 5.0;
constexpr double kZeroBelow =
    0.02;  // of such an axis: a hundred thousandth of the range is meant to be nothing
constexpr double kStep = 0.05;

/// A number without unit between 0 and about 1, where all of the range matters alike.
bool is_share(const Parameter& axis) {
  return axis.unit == "none" && axis.max >= 0.5 && axis.max <= 1.0;
}

bool starts_at_zero(const Parameter& axis) {
  return axis.type == ParameterType::real && axis.scale == ParameterScale::linear && axis.min == 0.0 &&
         axis.max > 0.0 && axis.step == 0.0 && !is_share(axis);
}

double power_from_zero(const Parameter& axis) {
  return axis.unit == "world" ? kPowerOfWorld : kPowerFromZero;
}

bool is_logarithmic(const Parameter& axis) {
  return axis.scale != ParameterScale::linear;
}

double number_at(const Parameter& axis, double position) {
  if (is_logarithmic(axis)) return axis.min * std::pow(axis.max / axis.min, position);
  if (starts_at_zero(axis) && position < kZeroBelow) return 0.0;
  if (starts_at_zero(axis)) return axis.max * std::pow(position, power_from_zero(axis));
  return axis.min + position * (axis.max - axis.min);
}

double three_digits(double number) {
  const std::string text = fmt::format("{:.3g}", number);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

double allowed_number(const Parameter& axis, double number) {
  if (axis.scale == ParameterScale::pow2) number = std::exp2(std::round(std::log2(number)));
  if (axis.type == ParameterType::integer) number = std::round(number);
  if (axis.type == ParameterType::real) {
    number = axis.step > 0.0 ? axis.min + axis.step * std::round((number - axis.min) / axis.step)
                             : three_digits(number);
  }
  return std::clamp(number, axis.min, axis.max);
}

}  // namespace

bool is_ordered(const Parameter& parameter) {
  return parameter.type == ParameterType::integer || parameter.type == ParameterType::real;
}

bool is_cost_like(const Parameter& parameter) {
  return std::ranges::find(kCostUnits, parameter.unit) != kCostUnits.end();
}

SearchSpace choose_search_space(std::span<const Parameter> parameters, std::span<const std::string> names,
                                std::string_view technique) {
  SearchSpace space;
  for (const std::string& name : names) {
    if (std::ranges::find(space, name, &Parameter::name) != space.end())
      fail_input(fmt::format("parameter '{}' is named twice", name));
    space.push_back(find_parameter(parameters, name, technique));
  }
  if (!names.empty()) return space;
  for (const Parameter& parameter : parameters) {
    if (parameter.tune && !is_cost_like(parameter)) space.push_back(parameter);
  }
  if (space.empty()) {
    fail_input(fmt::format("technique '{}' has no parameter to tune but its costs", technique), {},
               "name one with --parameters");
  }
  return space;
}

int level_count(const Parameter& axis) {
  switch (axis.type) {
    case ParameterType::boolean:
      return 2;
    case ParameterType::choice:
      return static_cast<int>(axis.choices.size());
    case ParameterType::integer:
    case ParameterType::real:
      break;
  }
  if (axis.scale == ParameterScale::pow2)
    return 1 + static_cast<int>(std::lround(std::log2(axis.max / axis.min)));
  if (axis.scale == ParameterScale::log) return 0;
  const double step = axis.type == ParameterType::integer ? 1.0 : axis.step;
  return step > 0.0 ? 1 + static_cast<int>(std::floor((axis.max - axis.min) / step + 1e-9)) : 0;
}

ParameterValue value_at(const Parameter& axis, double position) {
  position = std::clamp(position, 0.0, 1.0);
  if (!is_ordered(axis)) {
    const int count = level_count(axis);
    const int level = std::min(static_cast<int>(position * count), count - 1);
    if (axis.type == ParameterType::boolean) return level == 1;
    return axis.choices[static_cast<size_t>(level)];
  }
  const double number = allowed_number(axis, number_at(axis, position));
  if (axis.type == ParameterType::integer) return static_cast<int64_t>(std::llround(number));
  return number;
}

double position_of(const Parameter& axis, const ParameterValue& value) {
  const double number = numeric_value(axis, value);
  if (!is_ordered(axis)) return (number + 0.5) / level_count(axis);
  if (axis.min == axis.max) return 0.0;
  if (is_logarithmic(axis)) return std::log(number / axis.min) / std::log(axis.max / axis.min);
  if (starts_at_zero(axis)) return std::pow(number / axis.max, 1.0 / power_from_zero(axis));
  return (number - axis.min) / (axis.max - axis.min);
}

std::optional<ParameterValue> neighbour(const Parameter& axis, const ParameterValue& value, int direction) {
  if (!is_ordered(axis)) return std::nullopt;
  const int levels = level_count(axis);
  const double step = levels > 1 ? 1.0 / (levels - 1) : kStep;
  const ParameterValue next = value_at(axis, position_of(axis, value) + direction * step);
  return next == value ? std::nullopt : std::optional(next);
}

ParameterValues values_at(const SearchSpace& space, const Point& point, const ParameterValues& base) {
  ParameterValues values = base;
  for (size_t i = 0; i < space.size(); ++i) values[space[i].name] = value_at(space[i], point[i]);
  return values;
}

Point point_of(const SearchSpace& space, const ParameterValues& values) {
  Point point;
  for (const Parameter& axis : space) {
    const auto found = values.find(axis.name);
    point.push_back(position_of(axis, found == values.end() ? axis.default_value : found->second));
  }
  return point;
}

ParameterValues without_inactive(const SearchSpace& space, const IsActive& is_active,
                                 const ParameterValues& values, const ParameterValues& base) {
  if (!is_active) return values;
  ParameterValues plain = values;
  for (const Parameter& axis : space) {
    if (!is_active(axis, values)) plain[axis.name] = base.at(axis.name);
  }
  return plain;
}

}  // namespace umbrameter

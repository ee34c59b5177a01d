// SPDX-License-Identifier: Apache-2.0
#include "core/parameters.h"

#include <algorithm>

namespace umbrameter {

Parameter in_world(Parameter parameter, double diagonal_world) {
  if (!parameter.is_relative_to_scene) return parameter;
  parameter.default_value = diagonal_world * numeric_value(parameter, parameter.default_value);
  parameter.min *= diagonal_world;
  parameter.max *= diagonal_world;
  parameter.step *= diagonal_world;
  parameter.is_relative_to_scene = false;
  return parameter;
}

ParameterValue in_world(const Parameter& parameter, const ParameterValue& value, double diagonal_world) {
  if (!parameter.is_relative_to_scene) return value;
  const double number = numeric_value(parameter, value);
  if (std::holds_alternative<std::string>(value)) return diagonal_world * number;
  const double low = diagonal_world * parameter.min, high = diagonal_world * parameter.max;
  if (number >= low && number <= high) return value;
  fail_input(fmt::format("parameter '{}' = {} is outside its range [{:.4g}, {:.4g}] in this scene",
                         parameter.name, number, low, high),
             {},
             fmt::format("world units; the scene's diagonal is {:.4g}, and {} to {} of it are allowed",
                         diagonal_world, parameter.min, parameter.max));
}

ParameterValues in_world(std::span<const Parameter> parameters, ParameterValues values,
                         double diagonal_world) {
  for (const Parameter& parameter : parameters) {
    const auto found = values.find(parameter.name);
    if (found != values.end()) found->second = in_world(parameter, found->second, diagonal_world);
  }
  return values;
}

}  // namespace umbrameter

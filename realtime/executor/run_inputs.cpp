// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/run_inputs.h"

#include "realtime/manifest/names.h"

#include <cmath>

namespace umbrameter {
namespace {

glm::dvec2 full_extent(const Light& light) {
  if (light.type == LightType::rect) return light.size_world;
  if (light.type == LightType::sun) return glm::dvec2(2.0 * std::tan(light.half_angle_rad));
  return glm::dvec2(2.0 * light.radius_world);
}

}  // namespace

ExpressionVariables run_variables(const RunInputs& inputs) {
  ExpressionVariables variables = parameter_variables(inputs.technique.parameters, inputs.values);
  const Light& light = inputs.scene.light();
  const glm::dvec2 extent = full_extent(light);
  variables["screen.width"] = inputs.gbuffer.width();
  variables["screen.height"] = inputs.gbuffer.height();
  variables["light.width"] = extent.x;
  variables["light.height"] = extent.y;
  variables["light.type"] = static_cast<double>(light.type);
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    variables[fmt::format("light.{}", to_text(type))] = static_cast<double>(type);
  }
  return variables;
}

bool holds(const std::string& condition, const ExpressionVariables& variables, const FileLocation& where) {
  return condition.empty() || evaluate_expression(condition, variables, where) != 0.0;
}

int64_t whole_number(const ExpressionText& expression, const ExpressionVariables& variables, int64_t min,
                     int64_t max, std::string_view what) {
  const double value = evaluate_expression(expression.text, variables, expression.where);
  const auto fail = [&](const std::string& hint) {
    fail_input(fmt::format("{} = '{}' is {}", what, expression.text, value), expression.where, hint);
  };
  if (std::floor(value) != value) fail("it must be a whole number: write ceil() or floor()");
  if (value < static_cast<double>(min) || value > static_cast<double>(max)) {
    fail(fmt::format("it must be from {} to {}", min, max));
  }
  return static_cast<int64_t>(value);
}

}  // namespace umbrameter

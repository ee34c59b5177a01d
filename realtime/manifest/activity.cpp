// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/activity.h"

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

ExpressionVariables light_variables(const Light& light) {
  const glm::dvec2 extent = full_extent(light);
  ExpressionVariables variables;
  variables["light.width"] = extent.x;
  variables["light.height"] = extent.y;
  variables["light.type"] = static_cast<double>(light.type);
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun})
    variables[fmt::format("light.{}", to_text(type))] = static_cast<double>(type);
  return variables;
}

bool is_active(const Technique& technique, const Parameter& parameter, const ParameterValues& values,
               const Light& light) {
  if (parameter.when.empty()) return true;
  ExpressionVariables variables = parameter_variables(technique.parameters, values);
  variables.merge(light_variables(light));
  return Expression(parameter.when, parameter.where).evaluate(variables) != 0.0;
}

}  // namespace umbrameter

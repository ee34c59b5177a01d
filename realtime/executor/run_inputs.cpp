// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/run_inputs.h"

#include "realtime/manifest/activity.h"
#include "realtime/manifest/names.h"

#include <cmath>

namespace umbrameter {
ExpressionVariables run_variables(const RunInputs& inputs) {
  ExpressionVariables variables = parameter_variables(inputs.technique.parameters, inputs.values);
  variables.merge(light_variables(inputs.scene.light()));
  variables["screen.width"] = inputs.gbuffer.width();
  variables["screen.height"] = inputs.gbuffer.height();
  return variables;
}

bool holds(const Expression& condition, const ExpressionVariables& variables) {
  return condition.is_empty() || condition.evaluate(variables) != 0.0;
}

int64_t whole_number(const Expression& expression, const ExpressionVariables& variables, int64_t min,
                     int64_t max, std::string_view what) {
  const double value = expression.evaluate(variables);
  const auto fail = [&](const std::string& hint) {
    fail_input(fmt::format("{} = '{}' is {}", what, expression.text(), value), expression.where(), hint);
  };
  if (std::floor(value) != value) fail("it must be a whole number: write ceil() or floor()");
  if (value < static_cast<double>(min) || value > static_cast<double>(max)) {
    fail(fmt::format("it must be from {} to {}", min, max));
  }
  return static_cast<int64_t>(value);
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/run_inputs.h"

#include "realtime/harness/frame_uniforms.h"
#include "realtime/manifest/activity.h"
#include "realtime/manifest/names.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// Distance along the camera's axis to the farthest corner of the scene's box, at least to the near plane.
double farthest_corner(const Scene& scene) {
  const glm::dvec4 axis = camera_axis(scene.camera);
  const glm::dvec3 corner = glm::mix(scene.bounds_world.min, scene.bounds_world.max,
                                     glm::greaterThan(glm::dvec3(axis), glm::dvec3(0.0)));
  return std::max(glm::dot(axis, glm::dvec4(corner, 1.0)), scene.camera.near_world);
}

}  // namespace

ExpressionVariables run_variables(const RunInputs& inputs) {
  ExpressionVariables variables = parameter_variables(inputs.technique.parameters, inputs.values);
  variables.merge(light_variables(inputs.scene.light()));
  variables["screen.width"] = inputs.gbuffer.width();
  variables["screen.height"] = inputs.gbuffer.height();
  variables["scene.diagonal"] = inputs.scene.bounds_world.diagonal();
  variables["camera.near"] = inputs.scene.camera.near_world;
  variables["camera.far"] = farthest_corner(inputs.scene);
  variables["receivers.near"] = inputs.receiver_range.near_world;
  variables["receivers.far"] = inputs.receiver_range.far_world;
  const glm::dvec2 jitter = frame_jitter(inputs.frame);
  variables["frame.index"] = inputs.frame;
  variables["frame.jitter_x"] = jitter.x;
  variables["frame.jitter_y"] = jitter.y;
  for (const ValueDeclaration& value : inputs.technique.values)
    variables[value.name] = value.value.evaluate(variables);
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

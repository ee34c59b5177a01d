// SPDX-License-Identifier: Apache-2.0
#include "core/names.h"
#include "realtime/manifest/check_technique.h"
#include "realtime/manifest/names.h"

#include <algorithm>

namespace umbrameter {
namespace {

/// Whether an expression uses the parameter or one of its choices.
bool is_in_expressions(const Manifest& manifest, const Parameter& parameter) {
  if (manifest.expression_names.contains(parameter.name)) return true;
  return std::ranges::any_of(parameter.choices, [&](const std::string& choice) {
    return manifest.expression_names.contains(choice_variable(parameter, choice));
  });
}

/// A parameter nothing reads would be swept and tuned without any effect.
void check_is_read(const Manifest& manifest, const Parameter& parameter,
                   const std::set<std::string, std::less<>>& shader_tokens) {
  const bool is_host = parameter.stage == ParameterStage::host;
  const bool in_expressions = is_in_expressions(manifest, parameter);
  if (is_host) {
    if (in_expressions) return;
    fail_input(fmt::format("host parameter '{}' is never read by technique '{}'", parameter.name,
                           manifest.technique.id),
               parameter.where, "no expression, condition or fit uses it");
  }
  const std::string token =
      parameter.stage == ParameterStage::define ? macro_name(parameter.name) : parameter.name;
  if (shader_tokens.contains(token)) return;
  fail_input(fmt::format("{} parameter '{}' is never read by technique '{}': no shader uses {}",
                         to_text(parameter.stage), parameter.name, manifest.technique.id, token),
             parameter.where, in_expressions ? "only expressions use it: stage = \"host\"" : "");
}

/// What `when` may look at: other parameters, their choices, the light.
void check_when(const Technique& technique, const Parameter& parameter) {
  if (parameter.when.empty()) return;
  std::vector<std::string> known;
  for (const Parameter& other : technique.parameters) {
    if (other.name == parameter.name) continue;
    known.push_back(other.name);
    for (const std::string& choice : other.choices) known.push_back(choice_variable(other, choice));
  }
  for (const std::string& name : builtin_variables()) {
    if (name.starts_with("light.")) known.push_back(name);
  }
  const Expression when(parameter.when, parameter.where);
  for (const std::string& name : when.names()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    fail_input(
        fmt::format("parameter '{}': unknown name '{}' in when = '{}'", parameter.name, name, parameter.when),
        parameter.where, suggest_name(name, known));
  }
}

void check_presets(const Manifest& manifest) {
  const Technique& technique = manifest.technique;
  std::set<std::string> names;
  for (const Preset& preset : technique.presets) {
    if (!names.insert(preset.name).second) {
      fail_input(fmt::format("preset '{}' stands here a second time", preset.name), preset.where);
    }
    ParameterValues values = default_values(technique.parameters);
    for (const auto& [name, value] : preset.values) values[name] = value;
    for (const Expression& constraint : technique.constraints) {
      check_constraint(technique, constraint, values, fmt::format("preset '{}'", preset.name));
    }
  }
}

}  // namespace

void check_constraint(const Technique& technique, const Expression& constraint, const ParameterValues& values,
                      std::string_view of_what) {
  const ExpressionVariables variables = parameter_variables(technique.parameters, values);
  if (constraint.evaluate(variables) != 0.0) return;
  std::string seen;
  for (const std::string& name : constraint.names()) {
    if (!values.contains(name)) continue;
    seen += fmt::format("{}{} = {}", seen.empty() ? "" : ", ", name, to_text(values.at(name)));
  }
  fail_input(
      fmt::format("{} of technique '{}' break the constraint '{}'", of_what, technique.id, constraint.text()),
      constraint.where(), seen);
}

void check_parameters(const Manifest& manifest, const std::set<std::string, std::less<>>& shader_tokens) {
  for (const Parameter& parameter : manifest.technique.parameters)
    check_is_read(manifest, parameter, shader_tokens);
  const Technique& technique = manifest.technique;
  for (const Parameter& parameter : technique.parameters) check_when(technique, parameter);
  for (const ValueDeclaration& value : technique.values) {
    if (!manifest.expression_names.contains(value.name))
      fail_input(fmt::format("value '{}' is never used", value.name), value.where, "no expression names it");
  }
  const ParameterValues defaults = default_values(technique.parameters);
  for (const Expression& constraint : technique.constraints)
    check_constraint(technique, constraint, defaults, "the defaults");
  check_presets(manifest);
}

}  // namespace umbrameter

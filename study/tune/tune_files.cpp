// SPDX-License-Identifier: Apache-2.0
#include "study/tune/tune_files.h"

#include "core/version.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbrameter {
namespace {

bool is_tuned(const TuneResult& result, const std::string& name) {
  return std::ranges::find(result.tuned, name) != result.tuned.end();
}

std::string toml_text(const ParameterValue& value) {
  return std::holds_alternative<std::string>(value) ? "\"" + to_text(value) + "\"" : to_text(value);
}

std::string summary(const TunePlan& plan, const TuneResult& result) {
  return fmt::format("{} for {}: {} {:.3g} times the defaults'", plan.technique.id,
                     fmt::join(result.scenes, ", "), name_of(plan.objective), result.best.ratio);
}

/// The same length in the other unit.
std::string in_other_unit(const TuneResult& result, const Parameter& parameter, const ParameterValue& value) {
  const auto sweep = std::ranges::find(result.bias_sweeps, parameter.name, &BiasSweep::parameter);
  if (sweep == result.bias_sweeps.end() || !(sweep->texel_world > 0.0)) return "";
  const double bias = std::get<double>(value);
  if (parameter.unit == "texels")
    return fmt::format("  // {:.3g} world units at {:.3g} a texel", *sweep->world(bias), sweep->texel_world);
  return fmt::format("  // {:.3g} texels of {:.3g} world units", *sweep->texels(bias), sweep->texel_world);
}

}  // namespace

std::string preset_toml(const TunePlan& plan, const TuneResult& result) {
  std::string text = fmt::format(
      "# Made by umbrameter {} ({}): umbrameter validate ... --preset FILE. The [[preset]] may be pasted "
      "into a manifest.\n"
      "technique = \"{}\"\n\n[[preset]]\nname = \"tuned\"\ndoc = \"Tuned {}.\"\n[preset.values]\n",
      kVersion, kCommit, plan.technique.id, summary(plan, result));
  for (const Parameter& parameter : plan.parameters) {
    const ParameterValue& value = result.best.values.at(parameter.name);
    if (is_tuned(result, parameter.name) || value != parameter.default_value)
      text += fmt::format("{} = {}\n", parameter.name, toml_text(value));
  }
  return text;
}

std::string engine_block(const TunePlan& plan, const TuneResult& result) {
  std::string text = fmt::format("// {}\n", summary(plan, result));
  for (const Parameter& parameter : plan.parameters) {
    if (!is_tuned(result, parameter.name)) continue;
    const ParameterValue& value = result.best.values.at(parameter.name);
    text +=
        fmt::format("{} = {}{}\n", parameter.name, to_text(value), in_other_unit(result, parameter, value));
  }
  return text;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "results/tune/tune_files.h"

#include "core/toml_text.h"
#include "core/version.h"
#include "results/tune/engine_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbrameter {
namespace {

bool is_tuned(const TuneResult& result, const std::string& name) {
  return std::ranges::find(result.tuned, name) != result.tuned.end();
}

/// Engines have dots in their names.
std::string toml_key(const std::string& name) {
  return name.find('.') == std::string::npos ? name : toml_string(name);
}

std::string summary(const TuneResult& result) {
  return fmt::format("{} for {}: {} {:.3g} times the defaults'", result.head.technique,
                     fmt::join(result.scenes, ", "), name_of(result.head.objective), result.best.ratio);
}

/// The same length in the other unit.
std::string in_other_unit(const TuneResult& result, const Parameter& parameter, const ParameterValue& value) {
  if (parameter.type != ParameterType::real || !(result.texel_world > 0.0)) return "";
  const double length = std::get<double>(value);
  const std::optional<double> texels = in_texels(parameter.unit, length, result.texel_world),
                              world = in_world_units(parameter.unit, length, result.texel_world);
  if (!texels || !world) return "";
  if (parameter.unit == "texels")
    return fmt::format("  // {:.3g} world units at {:.3g} a texel", *world, result.texel_world);
  return fmt::format("  // {:.3g} texels of {:.3g} world units", *texels, result.texel_world);
}

}  // namespace

namespace {

/// [[preset]] with what was tuned and what else differs from the defaults; of one light unless `light` is empty.
std::string preset_table(const TuneResult& result, const std::string& light) {
  const std::string name = light.empty() ? "tuned" : "tuned for " + light;
  std::string text = fmt::format("\n[[preset]]\nname = {}\n", toml_string(name));
  if (!light.empty()) text += fmt::format("light = {}\n", toml_string(light));
  text += fmt::format("doc = {}\n[preset.values]\n", toml_string(fmt::format("Tuned {}.", summary(result))));
  for (const Parameter& parameter : result.head.parameters) {
    const ParameterValue& value = result.best.values.at(parameter.name);
    if (is_tuned(result, parameter.name) || value != parameter.default_value)
      text += fmt::format("{} = {}\n", toml_key(parameter.name), toml_value(value));
  }
  return text;
}

std::string preset_head(const TuneResult& result, std::string_view more) {
  return fmt::format(
      "# Made by umbrameter {} ({}): umbrameter validate ... --preset FILE.{}\ntechnique = \"{}\"\n",
      kVersion, kCommit, more, result.head.technique);
}

}  // namespace

std::string preset_toml(const TuneResult& result) {
  return preset_head(result, " The [[preset]] may be pasted into a manifest.") + preset_table(result, {});
}

std::string preset_toml(std::span<const LightTuning> tunings) {
  std::string text = preset_head(*tunings.front().result, " Each light has its own values.");
  for (const LightTuning& tuning : tunings) text += preset_table(*tuning.result, tuning.light);
  return text;
}

/// An engine's own settings, by its own names and in its own units.
std::string own_settings(const TuneResult& result) {
  std::string text;
  for (const Parameter& parameter : result.head.parameters) {
    const ParameterValue& value = result.best.values.at(parameter.name);
    if (!is_tuned(result, parameter.name) && value == parameter.default_value) continue;
    text += fmt::format("{} = {}", parameter.name, to_text(value));
    if (!parameter.unit.empty() && parameter.unit != "none") text += fmt::format("  // {}", parameter.unit);
    text += "\n";
  }
  return text;
}

/// What engines have a setting for, or do not need, then what they lack.
std::string engine_block(const TuneResult& result) {
  if (result.head.is_engine) return fmt::format("// {}\n{}", summary(result), own_settings(result));
  std::string settings, lacking;
  for (const Parameter& parameter : result.head.parameters) {
    if (!is_tuned(result, parameter.name)) continue;
    const ParameterValue& value = result.best.values.at(parameter.name);
    const std::string_view engines = engine_settings_of(parameter.name);
    std::string line =
        fmt::format("{} = {}{}\n", parameter.name, to_text(value), in_other_unit(result, parameter, value));
    if (!engines.empty()) line += fmt::format("//   {}\n", engines);
    (engines.empty() && !is_neutral(parameter, value) ? lacking : settings) += line;
  }
  std::string text = fmt::format("// {}\n{}", summary(result), settings);
  if (!lacking.empty())
    text +=
        "// No engine's light settings have these: they need a shader that does the same, or a search "
        "without them (--parameters).\n" +
        lacking;
  return text;
}

}  // namespace umbrameter

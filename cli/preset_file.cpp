// SPDX-License-Identifier: Apache-2.0
#include "cli/preset_file.h"

#include "core/names.h"
#include "core/toml.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

struct PresetTable {
  std::string light;
  std::vector<TomlEntry> values;
};

struct PresetFile {
  std::string technique;
  FileLocation where;
  std::vector<PresetTable> presets;
};

PresetTable read_preset(const TomlNode& node, bool is_one_of_several) {
  TomlReader table(node, "[[preset]]");
  table.text("name");
  table.text("doc", "");
  PresetTable preset{table.text("light", ""), {}};
  if (is_one_of_several && preset.light.empty())
    table.fail("light", "a preset file with several [[preset]] has one a light", "name its 'light'");
  const TomlNode& values = table.require("values");
  if (values.type != TomlNode::Type::table) table.fail("values", "'values' is not a table");
  preset.values = values.entries;
  table.finish();
  return preset;
}

PresetFile load(const std::string& file) {
  const TomlNode root = parse_toml_file(file);
  TomlReader reader(root, "a preset file");
  PresetFile preset;
  preset.technique = reader.text("technique");
  preset.where = reader.where("technique");
  const auto tables = reader.tables("preset");
  if (tables.empty())
    reader.fail("preset", "a preset file has one [[preset]], or one a light; this has none");
  for (const TomlNode* table : tables) {
    preset.presets.push_back(read_preset(*table, tables.size() > 1));
    const std::string& light = preset.presets.back().light;
    if (std::ranges::count(preset.presets, light, &PresetTable::light) > 1)
      fail_input(fmt::format("two presets are for light '{}'", light), table->where);
  }
  reader.finish();
  return preset;
}

ParameterValues read_values(const std::vector<TomlEntry>& entries, const Technique& technique) {
  std::vector<std::string> known;
  for (const Parameter& parameter : technique.parameters) known.push_back(parameter.name);
  ParameterValues values;
  for (const auto& [name, node] : entries) {
    const auto parameter = std::ranges::find(technique.parameters, name, &Parameter::name);
    if (parameter == technique.parameters.end()) {
      fail_input(fmt::format("technique '{}' has no parameter '{}'", technique.id, name), node.where,
                 suggest_name(name, known));
    }
    values[name] = read_parameter_value(*parameter, node);
  }
  return values;
}

}  // namespace

bool is_preset_file(const std::string& text) {
  return text.ends_with(".toml");
}

std::string technique_of_preset(const std::string& file) {
  return load(file).technique;
}

std::vector<LightPreset> read_preset_file(const std::string& file, const Technique& technique) {
  const PresetFile preset = load(file);
  if (preset.technique != technique.id) {
    fail_input(fmt::format("this preset is for technique '{}', not '{}'", preset.technique, technique.id),
               preset.where);
  }
  std::vector<LightPreset> presets;
  for (const PresetTable& table : preset.presets)
    presets.push_back({table.light, read_values(table.values, technique)});
  return presets;
}

}  // namespace umbrameter

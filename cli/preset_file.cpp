// SPDX-License-Identifier: Apache-2.0
#include "cli/preset_file.h"

#include "core/names.h"
#include "core/toml.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

struct PresetFile {
  std::string technique;
  FileLocation where;
  std::vector<TomlEntry> values;
};

PresetFile load(const std::string& file) {
  const TomlNode root = parse_toml_file(file);
  TomlReader reader(root, "a preset file");
  PresetFile preset;
  preset.technique = reader.text("technique");
  preset.where = reader.where("technique");
  const auto tables = reader.tables("preset");
  if (tables.size() != 1)
    reader.fail("preset", fmt::format("a preset file has one [[preset]], this has {}", tables.size()));
  TomlReader table(*tables.front(), "[[preset]]");
  table.text("name");
  table.text("doc", "");
  const TomlNode& values = table.require("values");
  if (values.type != TomlNode::Type::table) table.fail("values", "'values' is not a table");
  preset.values = values.entries;
  table.finish();
  reader.finish();
  return preset;
}

}  // namespace

bool is_preset_file(const std::string& text) {
  return text.ends_with(".toml");
}

std::string technique_of_preset(const std::string& file) {
  return load(file).technique;
}

ParameterValues read_preset_file(const std::string& file, const Technique& technique) {
  const PresetFile preset = load(file);
  if (preset.technique != technique.id) {
    fail_input(fmt::format("this preset is for technique '{}', not '{}'", preset.technique, technique.id),
               preset.where);
  }
  std::vector<std::string> known;
  for (const Parameter& parameter : technique.parameters) known.push_back(parameter.name);
  ParameterValues values;
  for (const auto& [name, node] : preset.values) {
    const auto parameter = std::ranges::find(technique.parameters, name, &Parameter::name);
    if (parameter == technique.parameters.end()) {
      fail_input(fmt::format("technique '{}' has no parameter '{}'", technique.id, name), node.where,
                 suggest_name(name, known));
    }
    values[name] = read_parameter_value(*parameter, node);
  }
  return values;
}

}  // namespace umbrameter

#include "realtime/manifest/read_manifest.h"

#include "core/names.h"
#include "core/toml.h"
#include "realtime/manifest/manifest_parts.h"
#include "realtime/manifest/names.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

std::vector<LightType> read_lights(TomlReader& reader) {
  const std::array<LightType, 4> types = {LightType::rect, LightType::disk, LightType::sphere,
                                          LightType::sun};
  Names known;
  for (const LightType type : types) known.emplace_back(to_text(type));
  std::vector<LightType> lights;
  reader.require("lights");
  for (const std::string& name : reader.texts("lights")) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
      reader.fail("lights", fmt::format("unknown light type '{}'", name), suggest_name(name, known));
    lights.push_back(types[static_cast<size_t>(found - known.begin())]);
  }
  if (lights.empty())
    reader.fail("lights", "no light type is supported", "name at least one of rect, disk, sphere, sun");
  return lights;
}

void add_parameters(Technique& technique, TomlReader& reader) {
  for (const TomlNode* table : reader.tables("parameter")) {
    TomlReader name_reader(*table, "[[parameter]]");
    read_name(name_reader, "name");
    technique.parameters.push_back(read_parameter(*table));
  }
}

void add_parameter_groups(Manifest& manifest, TomlReader& reader,
                          const std::filesystem::path& shared_folder) {
  for (const std::string& group : reader.texts("parameter_groups")) {
    const std::filesystem::path file = shared_folder / (group + ".toml");
    if (!std::filesystem::is_regular_file(file)) {
      Names known;
      if (std::filesystem::is_directory(shared_folder)) {
        for (const auto& entry : std::filesystem::directory_iterator(shared_folder)) {
          if (entry.path().extension() == ".toml") known.push_back(entry.path().stem().string());
        }
      }
      std::ranges::sort(known);
      reader.fail("parameter_groups", fmt::format("unknown parameter group '{}'", group),
                  suggest_name(group, known));
    }
    if (std::ranges::find(manifest.files, file) != manifest.files.end())
      reader.fail("parameter_groups", fmt::format("parameter group '{}' comes in a second time", group));
    manifest.files.push_back(file);
    const TomlNode document = parse_toml_file(file);
    TomlReader group_reader(document, "the parameter group");
    add_parameter_groups(manifest, group_reader, shared_folder);  // a group may begin with others
    add_parameters(manifest.technique, group_reader);
    group_reader.finish();
  }
}

Preset read_preset(const Technique& technique, const TomlNode& table) {
  TomlReader reader(table, "[[preset]]");
  Preset preset;
  preset.where = table.where;
  preset.name = reader.text("name");
  preset.doc = reader.text("doc", "");
  Names known;
  for (const Parameter& parameter : technique.parameters) known.push_back(parameter.name);
  const TomlNode& values = reader.require("values");
  if (values.type != TomlNode::Type::table)
    reader.fail("values", "'values' must be written as [preset.values]");
  for (const auto& [name, node] : values.entries) {
    const auto found = std::ranges::find(technique.parameters, name, &Parameter::name);
    if (found == technique.parameters.end()) {
      fail_input(fmt::format("preset '{}' sets an unknown parameter '{}'", preset.name, name), node.where,
                 suggest_name(name, known));
    }
    preset.values[name] = read_parameter_value(*found, node);
  }
  reader.finish();
  return preset;
}

Names parameter_names(const Technique& technique) {
  Names names;
  for (const Parameter& parameter : technique.parameters) {
    names.push_back(parameter.name);
    for (const std::string& choice : parameter.choices) names.push_back(choice_variable(parameter, choice));
  }
  return names;
}

void read_header(Technique& technique, TomlReader& reader) {
  constexpr int64_t kSchema = 1;
  if (reader.integer("schema") != kSchema) reader.fail("schema", "only schema = 1 is known");
  technique.id = reader.text("id");
  technique.title = reader.text("title");
  technique.summary = reader.text("summary");
  technique.family = reader.text("family");
  technique.references = reader.texts("references");
  technique.known_failures = reader.texts("known_failures");
  technique.lights = read_lights(reader);
}

void read_constraints(Manifest& manifest, TomlReader& reader, const Names& scope) {
  for (const std::string& text : reader.texts("constraints")) {
    manifest.constraints.push_back({text, reader.where("constraints")});
    check_expression(manifest, manifest.constraints.back(), scope);
    manifest.technique.constraints.push_back(text);
  }
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& folder, const std::filesystem::path& shared_folder) {
  const std::filesystem::path file = folder / "technique.toml";
  const TomlNode document = parse_toml_file(file);
  TomlReader reader(document, "the manifest");
  Manifest manifest;
  manifest.files.push_back(file);
  Technique& technique = manifest.technique;
  technique.folder = folder;
  read_header(technique, reader);
  add_parameter_groups(manifest, reader, shared_folder);
  add_parameters(technique, reader);

  Names scope = parameter_names(technique);
  read_constraints(manifest, reader, scope);
  scope.insert(scope.end(), builtin_variables().begin(), builtin_variables().end());
  for (const TomlNode* table : reader.tables("resource")) {
    technique.resources.push_back(read_resource(manifest, *table, scope));
  }
  for (const TomlNode* table : reader.tables("pass")) {
    technique.passes.push_back(read_pass(manifest, *table, scope, 0));
  }
  collect_loop_variables(technique.passes, scope);
  for (const TomlNode* table : reader.tables("view")) {
    technique.views.push_back(read_view(manifest, *table, scope));
  }
  for (const TomlNode* table : reader.tables("preset"))
    technique.presets.push_back(read_preset(technique, *table));
  reader.finish();
  return manifest;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
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

/// The manifest and what it includes, each file after those it includes itself.
struct Documents {
  std::vector<TomlNode> nodes;
  std::vector<std::filesystem::path> files;
};

[[noreturn]] void fail_include(const TomlReader& reader, const std::string& name,
                               const std::filesystem::path& shared_folder) {
  Names known;
  if (std::filesystem::is_directory(shared_folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(shared_folder)) {
      if (entry.path().extension() == ".toml") known.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(known);
  reader.fail("include", fmt::format("there is no shared manifest '{}'", name), suggest_name(name, known));
}

void add_included(Documents& documents, TomlReader& reader, const std::filesystem::path& shared_folder) {
  for (const std::string& name : reader.texts("include")) {
    const std::filesystem::path file = shared_folder / (name + ".toml");
    if (!std::filesystem::is_regular_file(file)) fail_include(reader, name, shared_folder);
    if (std::ranges::find(documents.files, file) != documents.files.end())
      reader.fail("include", fmt::format("'{}' comes in a second time", name));
    documents.files.push_back(file);
    TomlNode document = parse_toml_file(file);
    TomlReader included(document, "the shared manifest");
    add_included(documents, included, shared_folder);
    for (const std::string_view key : {"parameter", "constraints", "value", "resource", "pass", "view"})
      included.find(std::string(key));
    included.finish();
    documents.nodes.push_back(std::move(document));
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
    manifest.technique.constraints.emplace_back(text, reader.where("constraints"));
    check_expression(manifest, manifest.technique.constraints.back(), scope);
  }
}

/// Says what a technique costs and uses no parameter: one that nothing else reads is still without effect.
void read_cost(Manifest& manifest, TomlReader& reader, const Names& scope) {
  const auto used = manifest.expression_names;
  manifest.technique.compares_per_pixel = read_expression(manifest, reader, "compares_per_pixel", scope);
  manifest.expression_names = used;
}

void read_values(Manifest& manifest, TomlReader& reader, Names& scope) {
  for (const TomlNode* table : reader.tables("value")) {
    TomlReader source(*table, "[[value]]");
    const std::string name = read_name(source, "name");
    if (std::ranges::find(scope, name) != scope.end())
      source.fail("name", fmt::format("'{}' means something else already", name));
    manifest.technique.values.push_back(
        {name, require_expression(manifest, source, "value", scope), table->where});
    source.finish();
    scope.push_back(name);
  }
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& folder, const std::filesystem::path& shared_folder) {
  const std::filesystem::path file = folder / "technique.toml";
  const TomlNode document = parse_toml_file(file);
  TomlReader reader(document, "the manifest");
  Manifest manifest;
  Technique& technique = manifest.technique;
  technique.folder = folder;
  read_header(technique, reader);
  Documents documents;
  add_included(documents, reader, shared_folder);
  manifest.files = documents.files;
  manifest.files.push_back(file);
  std::vector<TomlReader> readers;
  for (const TomlNode& included : documents.nodes) readers.emplace_back(included, "the shared manifest");
  const auto for_all = [&](const auto& read) {
    for (TomlReader& included : readers) read(included);
    read(reader);
  };

  for_all([&](TomlReader& source) { add_parameters(technique, source); });
  Names scope = parameter_names(technique);
  for_all([&](TomlReader& source) { read_constraints(manifest, source, scope); });
  read_cost(manifest, reader, scope);
  scope.insert(scope.end(), builtin_variables().begin(), builtin_variables().end());
  for_all([&](TomlReader& source) { read_values(manifest, source, scope); });
  technique.frames_before = read_expression(manifest, reader, "frames_before", scope);
  for_all([&](TomlReader& source) {
    for (const TomlNode* table : source.tables("resource")) {
      if (is_buffer(*table)) {
        technique.buffers.push_back(read_buffer(manifest, *table, scope));
      } else {
        technique.resources.push_back(read_resource(manifest, *table, scope));
      }
    }
  });
  if (technique.has_history()) scope.insert(scope.end(), frame_variables().begin(), frame_variables().end());
  for_all([&](TomlReader& source) {
    for (const TomlNode* table : source.tables("pass"))
      technique.passes.push_back(read_pass(manifest, *table, scope, 0));
  });
  const Names outside_loops = scope;
  collect_loop_variables(technique.passes, scope);
  for_all([&](TomlReader& source) {
    for (const TomlNode* table : source.tables("view"))
      technique.views.push_back(read_view(manifest, *table, scope, outside_loops));
  });
  for (const TomlNode* table : reader.tables("preset"))
    technique.presets.push_back(read_preset(technique, *table));
  reader.finish();
  return manifest;
}

}  // namespace umbrameter

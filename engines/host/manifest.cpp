// SPDX-License-Identifier: Apache-2.0
#include "engines/host/manifest.h"

#include "core/files.h"
#include "core/hash.h"
#include "core/names.h"
#include "core/toml.h"
#include "engines/host/placeholders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifestName = "engine.toml";
constexpr uint64_t kMebibyte = uint64_t{1} << 20;
constexpr std::array kLightTypes = {LightType::rect, LightType::disk, LightType::sphere, LightType::sun};
constexpr std::array<std::string_view, 3> kPictureEndings = {".exr", ".hdr", ".pfm"};  // that hold floats
constexpr std::array<const char*, 4> kFileKeys = {"picture", "lit", "unlit", "surfaces"};

std::map<LightType, std::string> read_lights(TomlReader& reader) {
  const TomlNode& table = reader.require("lights");
  if (table.type != TomlNode::Type::table)
    reader.fail("lights", "'lights' is not a table", "[lights] with rect = \"what becomes of it\", ...");
  TomlReader lights_reader(table, "[lights]");
  std::map<LightType, std::string> lights;
  for (const LightType type : kLightTypes) {
    const std::string name(to_text(type));
    if (lights_reader.has(name)) lights[type] = lights_reader.text(name);
  }
  lights_reader.finish();
  if (lights.empty())
    reader.fail("lights", "no light type is supported", "name at least one of rect, disk, sphere, sun");
  return lights;
}

/// As for techniques, but for the stage: an engine's parameters all act in its own process.
Parameter read_engine_parameter(const TomlNode& table) {
  TomlNode complete = table;
  TomlNode stage;
  stage.type = TomlNode::Type::text;
  stage.text = to_text(ParameterStage::host);
  stage.where = table.where;
  complete.entries.push_back({"stage", stage});
  return read_parameter(complete);
}

void read_parameters(Engine& engine, TomlReader& reader) {
  for (const TomlNode* table : reader.tables("parameter")) {
    const Parameter parameter = read_engine_parameter(*table);
    if (std::ranges::find(engine.parameters, parameter.name, &Parameter::name) != engine.parameters.end())
      fail_input(fmt::format("parameter '{}' is declared twice", parameter.name), table->where);
    if (is_request_placeholder(parameter.name) || parameter.name == "preset")
      fail_input(
          fmt::format("a parameter cannot be called '{}': the name has a meaning of its own", parameter.name),
          table->where);
    engine.parameters.push_back(parameter);
  }
}

void read_presets(Engine& engine, TomlReader& reader) {
  for (const TomlNode* table : reader.tables("preset")) {
    TomlReader preset_reader(*table, "[[preset]]");
    EnginePreset preset{preset_reader.text("name"), preset_reader.text("doc", ""), {}};
    for (const auto& [name, node] : preset_reader.require("values").entries)
      preset.values[name] = read_parameter_value(find_parameter(engine.parameters, name, engine.id), node);
    preset_reader.finish();
    engine.presets.push_back(std::move(preset));
  }
}

/// Exactly one of adapter, command and pictures.
void read_form(Engine& engine, TomlReader& reader) {
  const bool has_files = reader.has("picture") || reader.has("lit") || reader.has("unlit");
  const int forms = (reader.has("adapter") ? 1 : 0) + (reader.has("command") ? 1 : 0) + (has_files ? 1 : 0);
  if (forms != 1)
    fail_input(
        fmt::format("an engine has one of 'adapter', 'command' and 'picture' (or 'lit' and 'unlit'), not {}",
                    forms),
        reader.where());
  if (reader.has("adapter")) {
    engine.form = EngineForm::adapter;
    engine.command = reader.texts("adapter");
    if (engine.command.empty()) reader.fail("adapter", "'adapter' names no program");
  } else if (reader.has("command")) {
    engine.form = EngineForm::command;
    engine.command = split_command(reader.text("command"), reader.where("command"));
  } else {
    engine.form = EngineForm::pictures;
  }
  for (const char* key : kFileKeys) {
    if (engine.form == EngineForm::pictures && reader.has(key)) engine.files[key] = reader.text(key);
  }
  if (has_files && engine.files.contains("picture") == engine.files.contains("lit"))
    fail_input("'picture' stands alone, 'lit' with 'unlit'", reader.where());
  if (engine.files.contains("lit") != engine.files.contains("unlit"))
    fail_input("'lit' and 'unlit' come as a pair", reader.where());
}

EngineLimits read_limits(TomlReader& reader) {
  EngineLimits limits;
  const auto positive = [&](const char* key, double fallback) {
    const double value = reader.number(key, fallback);
    if (value <= 0.0) reader.fail(key, fmt::format("'{}' is {}, not above 0", key, value));
    return value;
  };
  limits.start_s = positive("seconds_to_start", limits.start_s);
  limits.picture_s = positive("seconds_per_picture", limits.picture_s);
  const auto mebibytes = static_cast<double>(limits.memory_bytes / kMebibyte);
  limits.memory_bytes = static_cast<uint64_t>(positive("memory_mib", mebibytes)) * kMebibyte;
  return limits;
}

/// Paths of a manifest: {installed} and {folder} known, relative ones beside the manifest.
fs::path place_of(const std::string& text, const Engine& engine, const EnginePlaces& places,
                  const FileLocation& where) {
  const fs::path path = fill_placeholders(
      text, {{"folder", engine.folder.string()}, {"installed", places.installed.string()}}, where);
  return (path.is_absolute() ? path : engine.folder / path).lexically_normal();
}

/// Names and bytes of files; a file of many megabytes (a whole browser) by its size and time.
void hash_file(const fs::path& file, const std::string& name, Hasher& hasher) {
  constexpr uint64_t kReadable = 16 * kMebibyte;
  hasher.text(name);
  const uint64_t size = fs::file_size(file);
  if (size <= kReadable) {
    hasher.text(read_file(file));
    return;
  }
  hasher.number(static_cast<double>(size));
  hasher.number(static_cast<double>(fs::last_write_time(file).time_since_epoch().count()));
}

void hash_place(const fs::path& place, Hasher& hasher) {
  if (fs::is_regular_file(place)) return hash_file(place, place.filename().string(), hasher);
  if (!fs::is_directory(place)) return;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(place)) {
    const bool is_compiled = entry.path().parent_path().filename() == "__pycache__";
    if (entry.is_regular_file() && !is_compiled) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) hash_file(file, file.lexically_relative(place).generic_string(), hasher);
}

void check_texts(const Engine& engine, const FileLocation& where) {
  std::vector<std::string> known = placeholders_of(engine.form);
  for (const Parameter& parameter : engine.parameters) known.push_back(parameter.name);
  for (const std::string& argument : engine.command) check_placeholders(argument, known, where);
  for (const auto& [key, text] : engine.files) check_placeholders(text, known, where);
  if (engine.form != EngineForm::command) return;
  const auto names = [&](const std::string& name) {
    return std::ranges::any_of(engine.command, [&](const std::string& argument) {
      return argument.find("{" + name + "}") != std::string::npos;
    });
  };
  if (names("out") == (names("lit") && names("unlit")))
    fail_input("the command names neither {out} nor {lit} and {unlit}, or all of them", where,
               "{out} is the picture of visibility to write; {lit} and {unlit} are the pair with and without "
               "shadows");
}

std::vector<fs::path> engine_folders(const fs::path& engines) {
  std::vector<fs::path> folders;
  if (!fs::is_directory(engines)) return folders;
  for (const auto& entry : fs::directory_iterator(engines)) {
    if (fs::is_regular_file(entry.path() / kManifestName)) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  return folders;
}

/// Changes with any picture of the folder that may be meant.
std::string hash_of_pictures(const fs::path& pattern) {
  Hasher hasher;
  hasher.text(pattern.filename().string());
  std::vector<fs::path> files;
  if (fs::is_directory(pattern.parent_path())) {
    for (const auto& entry : fs::directory_iterator(pattern.parent_path())) {
      if (entry.is_regular_file() && entry.path().extension() == pattern.extension())
        files.push_back(entry.path());
    }
  }
  const bool has_placeholder = pattern.filename().string().find('{') != std::string::npos;
  if (!has_placeholder) files = {pattern};
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    if (fs::is_regular_file(file)) hash_file(file, file.filename().string(), hasher);
  }
  return hasher.hex();
}

Engine pictures_of(const fs::path& pattern) {
  const std::string name = pattern.filename().string();
  check_placeholders(name, placeholders_of(EngineForm::pictures), {});
  Engine engine;
  engine.id = pattern.stem().string();
  engine.title = name;
  engine.summary = "A finished picture.";
  engine.folder = pattern.parent_path();
  engine.form = EngineForm::pictures;
  engine.files = {{"picture", name}, {"surfaces", name}};
  for (const LightType type : kLightTypes) engine.lights[type] = "whatever the picture shows";
  engine.hash = hash_of_pictures(pattern);
  return engine;
}

}  // namespace

std::string_view to_text(EngineForm form) {
  constexpr std::array<std::string_view, 3> kTexts = {"adapter", "command", "pictures"};
  return kTexts[static_cast<size_t>(form)];
}

std::string_view to_text(EngineQuantity quantity) {
  return quantity == EngineQuantity::visibility ? "visibility" : "irradiance";
}

Engine load_engine(const fs::path& folder, const EnginePlaces& places) {
  const fs::path file = folder / kManifestName;
  if (!fs::is_regular_file(file))
    fail_input(fmt::format("'{}' is not an engine folder: it has no {}", folder.string(), kManifestName));
  const TomlNode document = parse_toml_file(file);
  TomlReader reader(document, "the manifest");
  constexpr int64_t kSchema = 1;
  if (reader.integer("schema") != kSchema) reader.fail("schema", "only schema = 1 is known");
  Engine engine;
  engine.folder = fs::absolute(folder).lexically_normal();
  engine.id = reader.text("id");
  engine.title = reader.text("title");
  engine.summary = reader.text("summary");
  engine.references = reader.has("references") ? reader.texts("references") : std::vector<std::string>{};
  engine.known_failures =
      reader.has("known_failures") ? reader.texts("known_failures") : std::vector<std::string>{};
  const std::array<std::string, 2> quantities = {"visibility", "irradiance"};
  engine.quantity = static_cast<EngineQuantity>(reader.choice("quantity", quantities));
  engine.lights = read_lights(reader);
  read_form(engine, reader);
  engine.limits = read_limits(reader);
  read_parameters(engine, reader);
  read_presets(engine, reader);
  check_texts(engine, reader.where(engine.form == EngineForm::command ? "command" : "adapter"));
  Hasher hasher;
  hash_place(engine.folder, hasher);
  for (const char* key : {"needs", "depends"}) {
    if (!reader.has(key)) continue;
    for (const std::string& text : reader.texts(key)) {
      const fs::path place = place_of(text, engine, places, reader.where(key));
      if (!fs::exists(place)) engine.missing.push_back(place);
      hash_place(place, hasher);
    }
  }
  reader.finish();
  for (std::string& argument : engine.command)
    argument =
        fill_some(argument, {{"folder", engine.folder.string()}, {"installed", places.installed.string()}});
  engine.hash = hasher.hex();
  return engine;
}

std::vector<Engine> list_engines(const EnginePlaces& places) {
  std::vector<Engine> engines;
  for (const fs::path& folder : engine_folders(places.engines))
    engines.push_back(load_engine(folder, places));
  std::ranges::sort(engines, {}, &Engine::id);
  return engines;
}

fs::path find_engine_folder(const std::string& id_or_path, const EnginePlaces& places) {
  const bool is_id = id_or_path.find('/') == std::string::npos && !id_or_path.starts_with('.');
  if (is_id && fs::is_regular_file(places.engines / id_or_path / kManifestName))
    return places.engines / id_or_path;
  if (fs::is_regular_file(fs::path(id_or_path) / kManifestName)) return id_or_path;
  return {};
}

bool is_picture_path(const std::string& text) {
  const std::string ending = fs::path(text).extension().string();
  return std::ranges::find(kPictureEndings, ending) != kPictureEndings.end();
}

bool names_engine(const std::string& text, const EnginePlaces& places) {
  return is_picture_path(text) || !find_engine_folder(text, places).empty();
}

std::optional<Engine> find_engine(const std::string& text, const EnginePlaces& places) {
  if (is_picture_path(text)) return pictures_of(fs::absolute(text).lexically_normal());
  const fs::path folder = find_engine_folder(text, places);
  if (folder.empty()) return std::nullopt;
  return load_engine(folder, places);
}

void require_installed(const Engine& engine) {
  if (engine.missing.empty()) return;
  fail_environment(fmt::format("engine '{}' is not installed: '{}' is not there", engine.id,
                               engine.missing.front().string()),
                   "scripts/install_engines.sh installs what engines need");
}

}  // namespace umbrameter

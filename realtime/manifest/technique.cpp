// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/technique.h"

#include "core/files.h"
#include "core/hash.h"
#include "core/names.h"
#include "realtime/manifest/check_technique.h"
#include "realtime/manifest/names.h"
#include "realtime/manifest/shader_files.h"

#include <algorithm>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kManifestName = "technique.toml";
constexpr std::string_view kPresetParameter = "preset";
constexpr std::string_view kStagePrefix = "stage.";

/// Of names and texts, never of absolute places, so that a copied folder keeps its hash.
std::string hash_files(const Manifest& manifest, const ShaderFiles& shaders) {
  const fs::path& folder = manifest.technique.folder;
  std::vector<fs::path> files = manifest.files;
  files.insert(files.end(), shaders.dependencies.begin(), shaders.dependencies.end());
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::map<std::string, fs::path> by_name;
  for (const fs::path& file : files) {
    const std::string inside = file.lexically_relative(folder).generic_string();
    by_name.emplace(inside.starts_with("..") || inside.empty() ? file.filename().string() : inside, file);
  }
  Hasher hasher;
  for (const auto& [name, file] : by_name) hasher.text(name).text(read_file(file));
  return hasher.hex();
}

std::vector<fs::path> technique_folders(const fs::path& techniques_folder) {
  if (!fs::is_directory(techniques_folder)) {
    fail_input(fmt::format("'{}' is not a folder of techniques", techniques_folder.string()));
  }
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(techniques_folder)) {
    if (fs::is_regular_file(entry.path() / kManifestName)) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  return folders;
}

const Preset& find_preset(const Technique& technique, const std::string& name) {
  const auto found = std::ranges::find(technique.presets, name, &Preset::name);
  if (found != technique.presets.end()) return *found;
  std::vector<std::string> names;
  for (const Preset& preset : technique.presets) names.push_back(preset.name);
  fail_input(fmt::format("technique '{}' has no preset '{}'", technique.id, name), {},
             suggest_name(name, names));
}

}  // namespace

bool Technique::supports(LightType type) const {
  return std::ranges::find(lights, type) != lights.end();
}

Technique load_technique(const fs::path& folder, const fs::path& shared_folder,
                         const fs::path& shaders_folder) {
  if (!fs::is_regular_file(folder / kManifestName)) {
    fail_input(fmt::format("'{}' is not a technique folder: it has no {}", folder.string(), kManifestName));
  }
  const fs::path shaders = shaders_folder.empty() ? shared_folder / ".." / ".." / "shaders" : shaders_folder;
  Manifest manifest = read_manifest(folder, shared_folder);
  check_passes(manifest.technique);
  check_frames(manifest.technique);
  const ShaderFiles files = read_shader_files(manifest.technique, shaders);
  check_parameters(manifest, files.tokens);
  manifest.technique.hash = hash_files(manifest, files);
  return std::move(manifest.technique);
}

std::vector<Technique> list_techniques(const fs::path& techniques_folder, const fs::path& shaders_folder) {
  std::vector<Technique> techniques;
  for (const fs::path& folder : technique_folders(techniques_folder)) {
    techniques.push_back(load_technique(folder, techniques_folder / "shared", shaders_folder));
  }
  std::ranges::sort(techniques, {}, &Technique::id);
  return techniques;
}

Technique find_technique(const std::string& id_or_path, const fs::path& techniques_folder,
                         const fs::path& shaders_folder) {
  const fs::path shared_folder = techniques_folder / "shared";
  std::vector<std::string> ids;
  for (const fs::path& folder : technique_folders(techniques_folder)) {
    ids.push_back(folder.filename().string());
    if (ids.back() == id_or_path) return load_technique(folder, shared_folder, shaders_folder);
  }
  if (fs::is_directory(id_or_path)) return load_technique(id_or_path, shared_folder, shaders_folder);
  fail_input(fmt::format("there is no technique '{}'", id_or_path), {}, suggest_name(id_or_path, ids));
}

ParameterValues resolve_parameters(const Technique& technique, const ParameterValues& overrides) {
  ParameterValues values = default_values(technique.parameters);
  if (const auto preset = overrides.find(kPresetParameter); preset != overrides.end()) {
    for (const auto& [name, value] : find_preset(technique, to_text(preset->second)).values)
      values[name] = value;
  }
  for (const auto& [name, value] : overrides) {
    if (name == kPresetParameter) continue;
    if (name.starts_with(kStagePrefix)) {
      values[name] = value;
      continue;
    }
    // Through its text: a caller may hold 4 where the parameter is real.
    const Parameter& parameter = find_parameter(technique.parameters, name, technique.id);
    values[name] = parse_parameter_value(parameter, to_text(value));
  }
  for (const Expression& constraint : technique.constraints) {
    check_constraint(technique, constraint, values, "the parameters");
  }
  return values;
}

std::optional<double> compares_per_pixel(const Technique& technique, const ParameterValues& values) {
  const Expression& expression = technique.compares_per_pixel;
  if (expression.is_empty()) return std::nullopt;
  return expression.evaluate(parameter_variables(technique.parameters, values));
}

Technique with_stages(Technique technique, const ParameterValues& values) {
  for (const auto& [name, value] : values) {
    if (!name.starts_with(kStagePrefix)) continue;
    const Parameter& declared =
        find_parameter(technique.parameters, name.substr(kStagePrefix.size()), technique.id);
    const std::string stage = to_text(value);
    if (stage != "uniform" && stage != "define")
      fail_input(fmt::format("'{} = {}' is no stage to switch to", name, stage), {}, "define or uniform");
    const bool is_number = declared.type == ParameterType::integer || declared.type == ParameterType::real;
    if (declared.stage != ParameterStage::define || !is_number) {
      fail_input(fmt::format("the stage of parameter '{}' of technique '{}' cannot be switched",
                             declared.name, technique.id),
                 declared.where, "only numbers with stage = \"define\" can");
    }
    const auto index = static_cast<size_t>(&declared - technique.parameters.data());
    if (stage == "uniform") technique.parameters[index].stage = ParameterStage::uniform;
  }
  return technique;
}

bool is_switched_to_uniform(const ParameterValues& values, const std::string& parameter) {
  const auto found = values.find(std::string(kStagePrefix) + parameter);
  return found != values.end() && to_text(found->second) == "uniform";
}

}  // namespace umbrameter

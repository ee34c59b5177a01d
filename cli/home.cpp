// SPDX-License-Identifier: Apache-2.0
#include "cli/home.h"

#include "cli/preset_file.h"
#include "cli/run_renderer.h"
#include "cli/scene_options.h"
#include "core/data_folder.h"
#include "core/error.h"
#include "realtime/manifest/activity.h"
#include "realtime/realtime.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace umbrameter {
namespace {

constexpr const char* kEngineFamily = "engine";

/// Under any light of the technique; none of an engine, which has no groups of parameters.
std::vector<Parameter> acting_parameters(const Technique& technique, const ParameterValues& values) {
  std::vector<Parameter> acting;
  if (technique.family == kEngineFamily) return acting;
  std::ranges::copy_if(technique.parameters, std::back_inserter(acting), [&](const Parameter& parameter) {
    return std::ranges::any_of(technique.lights, [&](LightType type) {
      Light light;
      light.type = type;
      return is_active(technique, parameter, values, light);
    });
  });
  return acting;
}

TechniqueRun run_of(const Technique& technique, const std::string& request, const std::string& label,
                    const ParameterValues& overrides) {
  const ParameterValues parameters = resolve_parameters(technique, overrides);
  return {.technique = request,
          .id = technique.id,
          .label = label,
          .title = technique.title,
          .hash = technique.hash,
          .parameters = parameters,
          .lights = technique.lights,
          .declared = acting_parameters(technique, parameters)};
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t start = 0;
  while (true) {
    const size_t end = text.find(separator, start);
    parts.push_back(text.substr(start, end - start));
    if (end == std::string::npos) return parts;
    start = end + 1;
  }
}

/// As the command line says them, with those of a preset file; `light` is empty where they are for any.
std::vector<LightPreset> parse_assignments(const Technique& technique,
                                           const std::vector<std::string>& assignments) {
  ParameterValues values;
  std::vector<LightPreset> from_file;
  for (const std::string& assignment : assignments) {
    const auto [name, text] = split_assignment(assignment);
    if (values.count(name) > 0 || (name == "preset" && !from_file.empty()))
      fail_input(fmt::format("parameter '{}' of '{}' is given twice", name, technique.id));
    if (name == "preset" && is_preset_file(text)) {
      from_file = read_preset_file(text, technique);
      continue;
    }
    if (name == "preset" || name.starts_with("stage.")) {  // pseudo-parameters
      values[name] = text;
      continue;
    }
    values[name] = parse_parameter_value(find_parameter(technique.parameters, name, technique.id), text);
  }
  if (from_file.empty()) return {{"", values}};
  for (LightPreset& preset : from_file) {
    ParameterValues all = values;  // what the command line says counts more
    all.merge(preset.values);
    preset.values = std::move(all);
  }
  return from_file;
}

/// A path to a folder or a picture is passed on as an absolute path, an id as it is.
std::string request_text(const std::string& id_or_path) {
  const bool is_folder =
      id_or_path.find('/') != std::string::npos && std::filesystem::is_directory(id_or_path);
  return is_folder || is_picture_path(id_or_path) ? std::filesystem::absolute(id_or_path).string()
                                                  : id_or_path;
}

/// What scripts/install_engines.sh wrote.
std::filesystem::path installed_engines(const std::filesystem::path& root) {
  const char* chosen = std::getenv("UMBRAMETER_ENGINES");
  if (chosen != nullptr && *chosen != '\0') return std::filesystem::absolute(chosen);
  return root / "engines" / "installed";
}

}  // namespace

Home find_home() {
  const std::filesystem::path root = find_data_folder(program_file());
  return {root / "scenes" / "library",
          root / "realtime" / "techniques",
          root / "realtime" / "shaders",
          {root / "engines", installed_engines(root)}};
}

SceneSearch scene_search(const GlobalOptions& options, const Home& home) {
  if (!options.assets.empty() && !std::filesystem::is_directory(options.assets)) {
    fail_input(fmt::format("the assets folder '{}' is not there", options.assets), {},
               "--assets or UMBRAMETER_ASSETS names the folder with the models");
  }
  return {options.assets, home.library, options.light, chosen_time(options)};
}

std::vector<TechniqueRun> choose_technique_runs(const std::string& text,
                                                const std::vector<std::string>& assignments,
                                                const Home& home) {
  const size_t colon = std::filesystem::is_directory(text) ? std::string::npos : text.find(':');
  const std::string id_or_path = text.substr(0, colon);
  const Technique technique = find_run(id_or_path, home);
  std::vector<std::string> all = assignments;
  std::string label = technique.id;
  if (colon != std::string::npos) {
    const std::string settings = text.substr(colon + 1);
    label += ":" + settings;
    const auto parts = split(settings, ',');
    all.insert(all.end(), parts.begin(), parts.end());
  }
  std::vector<TechniqueRun> runs;
  for (const LightPreset& values : parse_assignments(technique, all)) {
    runs.push_back(run_of(technique, request_text(id_or_path), label, values.values));
    runs.back().only_light = values.light;
  }
  return runs;
}

TechniqueRun choose_technique(const std::string& text, const std::vector<std::string>& assignments,
                              const Home& home, const std::string& light) {
  std::vector<TechniqueRun> runs = choose_technique_runs(text, assignments, home);
  std::vector<std::string> lights;
  for (TechniqueRun& run : runs) {
    if (run.only_light.empty() || run.only_light == light) return std::move(run);
    lights.push_back(run.only_light);
  }
  fail_input(light.empty()
                 ? fmt::format("'{}' has values for single lights, which this command does not take", text)
                 : fmt::format("'{}' has no values for light '{}'", text, light),
             {}, fmt::format("it has them for: {}", fmt::join(lights, ", ")));
}

TechniqueRun technique_with(const std::string& id_or_path, const ParameterValues& parameters,
                            const Home& home) {
  const Technique technique = find_run(id_or_path, home);
  return run_of(technique, request_text(id_or_path), technique.id, parameters);
}

std::vector<TechniqueRun> all_techniques(const Home& home) {
  std::vector<TechniqueRun> runs;
  for (const Technique& technique : list_techniques(home.techniques)) {
    runs.push_back(run_of(technique, technique.id, technique.id, {}));
  }
  return runs;
}

Technique find_run(const std::string& id_or_path, const Home& home) {
  const std::optional<Engine> found = find_engine(id_or_path, home.engines);
  if (!found) return find_technique(id_or_path, home.techniques);
  const Engine& engine = *found;
  Technique technique;
  technique.id = engine.id;
  technique.title = engine.title;
  technique.summary = engine.summary;
  technique.family = kEngineFamily;
  technique.references = engine.references;
  technique.known_failures = engine.known_failures;
  for (const auto& [type, text] : engine.lights) technique.lights.push_back(type);
  technique.folder = engine.folder;
  technique.parameters = engine.parameters;
  for (const EnginePreset& preset : engine.presets)
    technique.presets.push_back({preset.name, preset.doc, preset.values, {}});
  technique.hash = engine.hash;
  return technique;
}

std::unique_ptr<Renderer> open_gl_renderer(const GlobalOptions& options, const Home& home,
                                           bool cull_casters) {
  return make_realtime_renderer({.techniques_folder = home.techniques,
                                 .shaders_folder = home.shaders,
                                 .device = options.device,
                                 .cull_casters = cull_casters,
                                 .keep_textures = cull_casters});
}

std::unique_ptr<Renderer> open_realtime_renderer(const GlobalOptions& options, const Home& home,
                                                 bool cull_casters) {
  return std::make_unique<RunRenderer>(open_gl_renderer(options, home, cull_casters), home.engines);
}

}  // namespace umbrameter

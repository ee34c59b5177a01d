// SPDX-License-Identifier: Apache-2.0
#include "cli/study_runs.h"

#include "cli/preset_file.h"
#include "core/error.h"
#include "core/names.h"
#include "results/bench/claims.h"
#include "scenes/choose_light.h"
#include "scenes/import_scene.h"
#include "scenes/seen_from.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

constexpr std::string_view kStagePrefix = "stage.";

/// The place beside the study if there is one, as a path from here.
std::string beside(const std::filesystem::path& study_file, const std::string& name) {
  if (name.find('/') == std::string::npos && !name.ends_with(".toml") && !is_importable(name)) return name;
  const std::filesystem::path place = study_file.parent_path() / name;
  return std::filesystem::exists(place) ? std::filesystem::absolute(place).string() : name;
}

std::string picture_beside(const std::filesystem::path& study_file, const StudyRun& run) {
  if (!is_picture_path(run.technique))
    fail_input(fmt::format("'{}' is no picture of floats", run.technique), run.where,
               "name an EXR, HDR or PFM file; {name} in it stands for the scene's name");
  return (std::filesystem::absolute(study_file).parent_path() / run.technique).lexically_normal().string();
}

ParameterValue read_value(const Technique& technique, const std::string& name, const TomlNode& node) {
  if (name.starts_with(kStagePrefix) && node.type == TomlNode::Type::text) return node.text;
  std::vector<std::string> known;
  for (const Parameter& parameter : technique.parameters) {
    if (parameter.name == name) return read_parameter_value(parameter, node);
    known.push_back(parameter.name);
  }
  fail_input(fmt::format("technique '{}' has no parameter '{}'", technique.id, name), node.where,
             suggest_name(name, known));
}

/// What the command line chooses, else the study, else every light.
std::vector<size_t> chosen_lights(const StudyFile& study, const Scene& scene, const std::string& given) {
  if (!given.empty() || study.lights.empty()) return choose_lights(scene.lights, given);
  std::vector<size_t> chosen;
  for (const std::string& name : study.lights) chosen.push_back(find_light(scene.lights, name));
  return chosen;
}

/// Absent: each scene as its file says.
std::vector<std::optional<AnimationTime>> moments_of(const StudyFile& study) {
  std::vector<std::optional<AnimationTime>> moments;
  for (const double time_s : study.times_s) moments.push_back(AnimationTime{time_s, study.animation});
  if (moments.empty()) moments.emplace_back();
  return moments;
}

StudyScene seen_by(const StudyCamera& camera, const StudyScene& own) {
  return {own.name, seen_from(own.scene, camera_in(camera, own.scene.camera)), camera.name};
}

/// One, or one a light where the preset is a file with values for single lights.
std::vector<TechniqueRun> choose_runs(const StudyRun& run, const std::filesystem::path& study_file,
                                      const std::string& request, const Technique& technique) {
  ParameterValues own;
  for (const auto& [name, node] : run.values) own[name] = read_value(technique, name, node);
  std::vector<LightPreset> presets{{}};
  if (is_preset_file(run.preset))
    presets = read_preset_file(beside(study_file, run.preset), technique);
  else if (!run.preset.empty())
    own["preset"] = run.preset;
  std::vector<TechniqueRun> runs;
  for (LightPreset& preset : presets) {
    ParameterValues values = own;  // what the study says counts more
    values.merge(preset.values);
    const ParameterValues complete = resolve_parameters(technique, values);
    with_stages(technique, complete);  // finds stages that cannot be switched
    runs.push_back({.technique = request,
                    .id = technique.id,
                    .label = run.label,
                    .title = technique.title,
                    .hash = technique.hash,
                    .parameters = complete,
                    .lights = technique.lights,
                    .only_light = preset.light});
  }
  return runs;
}

}  // namespace

std::vector<StudyScene> load_study_scenes(const StudyFile& study, const std::filesystem::path& file,
                                          const SceneSearch& search, Progress& progress) {
  std::vector<StudyScene> scenes;
  progress.begin("loading scenes", study.scenes.size());
  for (const std::string& name : study.scenes) {
    for (const std::optional<AnimationTime>& at : moments_of(study)) {
      SceneSearch own = search;
      own.at = at;
      const Scene all_lit = load_scene(resolve_scene(beside(file, name), own), own);
      for (const size_t light : chosen_lights(study, all_lit, search.light)) {
        StudyScene scene{lit_name(timed_name(name, at), all_lit.lights, light), lit_by(all_lit, light)};
        for (const StudyCamera& camera : study.cameras) scenes.push_back(seen_by(camera, scene));
        if (study.cameras.empty()) scenes.push_back(std::move(scene));
      }
    }
    progress.advance(1);
  }
  progress.end();
  return scenes;
}

std::vector<BenchRun> choose_study_runs(const StudyFile& study, const std::filesystem::path& file,
                                        const Home& home) {
  std::map<std::string, Technique> techniques;
  std::vector<TechniqueRun> runs;
  std::vector<RunCost> costs;
  for (const StudyRun& run : study.runs) {
    const std::string request = run.is_picture ? picture_beside(file, run) : beside(file, run.technique);
    if (!techniques.contains(request)) techniques[request] = find_run(request, home);
    for (TechniqueRun& chosen : choose_runs(run, file, request, techniques[request])) {
      costs.push_back({run.label, compares_per_pixel(techniques[request], chosen.parameters)});
      runs.push_back(std::move(chosen));
    }
  }
  require_fair_costs(study.claims, costs);
  std::vector<BenchRun> all;
  for (const uint64_t seed : study.seeds) {
    for (size_t i = 0; i < runs.size(); ++i) all.push_back({runs[i], seed, costs[i].compares_per_pixel});
  }
  return all;
}

std::vector<Quality> choose_study_qualities(const StudyFile& study, const QualityOptions& given) {
  if (study.qualities.size() > 1 &&
      (given.width || given.height || given.samples_per_pixel || given.target_se)) {
    fail_input(fmt::format("the study has {} qualities, each with a size and samples of its own",
                           study.qualities.size()),
               study.where, "leave out --width, --height and --spp");
  }
  std::vector<Quality> qualities;
  for (const std::string& name : study.qualities) {
    QualityOptions options = given;
    options.quality = name;
    options.where = study.where;
    options.seed = study.seeds.front();
    if (!options.width) options.width = study.width_px;
    if (!options.height) options.height = study.height_px;
    if (!options.samples_per_pixel) options.samples_per_pixel = study.samples_per_pixel;
    if (!options.target_se) options.target_se = study.target_se;
    qualities.push_back(choose_quality(options));
  }
  return qualities;
}

std::string quality_heading(const Quality& quality) {
  const PictureQuality& picture = quality.picture;
  return fmt::format("{}, {} x {} px, {} samples\n", quality.name, picture.width_px, picture.height_px,
                     picture.samples_per_pixel);
}

}  // namespace umbrameter

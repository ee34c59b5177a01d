// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/duration.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/quality.h"
#include "cli/reuse.h"
#include "cli/scene_options.h"
#include "cli/tune_text.h"
#include "core/error.h"
#include "core/files.h"
#include "lab/renamed_progress.h"
#include "realtime/manifest/activity.h"
#include "report/report.h"
#include "results/metadata.h"
#include "results/tune/tune_files.h"
#include "results/tune/tune_json.h"
#include "study/tune/lengths.h"
#include "study/tune/lit_sum.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

struct TuneOptions {
  std::vector<std::string> scenes;
  std::string technique;
  std::string objective = "rmse";
  std::vector<std::string> parameters;
  std::string time_limit = "60s";
  size_t evaluations = 0;
  int cameras = 5;
  int grid = 0;
  bool no_coarse = false;
  bool no_reuse = false;
  bool together = false;
  QualityOptions quality{
      .quality = "quick", .width = {}, .height = {}, .samples_per_pixel = {}, .target_se = {}, .where = {}};
};

// Of quality quick without sizes: hundreds of pictures are drawn, from many cameras.
constexpr int kQuickWidth_px = 320, kQuickHeight_px = 180;
constexpr int kCoarseFactor = 2;      // of each side; samples go with its square
constexpr int kLeastCoarse_px = 160;  // across: smaller pictures hold too few penumbrae to rank anything
constexpr double kMillisecondsPerSecond = 1e3;

Quality choose_tune_quality(QualityOptions options) {
  if (options.quality == "quick" && !options.width && !options.height) {
    options.width = kQuickWidth_px;
    options.height = kQuickHeight_px;
  }
  return choose_quality(options);
}

PictureQuality coarse_picture(PictureQuality picture) {
  picture.width_px /= kCoarseFactor;
  picture.height_px /= kCoarseFactor;
  picture.samples_per_pixel /= kCoarseFactor * kCoarseFactor;
  return picture;
}

TunePlan make_plan(const TuneOptions& options, const Home& home) {
  TunePlan plan;
  plan.technique = choose_technique(options.technique, {}, home);
  const Technique technique = find_run(plan.technique.technique, home);
  plan.parameters = technique.parameters;
  plan.is_engine = names_engine(plan.technique.technique, home.engines);
  for (const Preset& preset : technique.presets) plan.presets.push_back({preset.name, preset.values});
  plan.tuned = options.parameters;
  plan.objective = choose_objective(options.objective);
  plan.time_limit_s = milliseconds("--time-limit", options.time_limit) / kMillisecondsPerSecond;
  plan.evaluations = options.evaluations;
  plan.cameras = options.cameras;
  plan.grid_steps = options.grid;
  choose_search_space(plan.parameters, plan.tuned,
                      technique.id);  // finds unknown names before anything is loaded
  return plan;
}

/// What is tuned together: all jobs, or those under the light of one name.
struct TuneGroup {
  std::string light;  // empty: any
  std::vector<SceneJob> jobs;
  std::vector<std::string> scenes;  // of each job, as given
};

/// A group a light as soon as a scene has several, in order of appearance.
std::vector<TuneGroup> load_groups(const TuneOptions& options, const TunePlan& plan,
                                   const SceneSearch& search) {
  TuneGroup all;
  bool has_several = false;
  for (const std::string& name : options.scenes) {
    std::vector<SceneJob> jobs = load_scene_jobs(name, search);
    has_several = has_several || jobs.size() > 1;
    for (SceneJob& job : jobs) {
      if (const auto reason = skip_reason(plan.technique, job.scene))
        fail_input(fmt::format("technique '{}' {}: scene '{}'", plan.technique.id, *reason, job.name));
      all.jobs.push_back(std::move(job));
      all.scenes.push_back(name);
    }
  }
  std::vector<TuneGroup> groups;
  if (options.together || !has_several) {
    groups.push_back(std::move(all));
    return groups;
  }
  for (size_t i = 0; i < all.jobs.size(); ++i) {
    const std::string light = all.jobs[i].scene.light().name;
    auto group = std::ranges::find(groups, light, &TuneGroup::light);
    if (group == groups.end()) group = groups.insert(groups.end(), TuneGroup{light, {}, {}});
    group->jobs.push_back(std::move(all.jobs[i]));
    group->scenes.push_back(all.scenes[i]);
  }
  return groups;
}

/// On any of the scenes.
IsActive activity(const TunePlan& plan, std::span<const SceneJob> scenes, const Home& home) {
  std::vector<Light> lights;
  for (const SceneJob& job : scenes) lights.push_back(job.scene.light());
  return [technique = find_run(plan.technique.technique, home), lights](const Parameter& parameter,
                                                                        const ParameterValues& values) {
    return std::ranges::any_of(
        lights, [&](const Light& light) { return is_active(technique, parameter, values, light); });
  };
}

/// A group with its own ranges, and what was found.
struct GroupTuning {
  TuneGroup* group = nullptr;
  TunePlan plan;
  TuneResult result;
};

/// "pcf_disk", or "pcf_disk-key" for light "key".
std::string stem_of(const GroupTuning& tuning, const std::string& light) {
  return file_name_of(tuning.plan.technique.id + (light.empty() ? "" : "-" + light));
}

std::vector<LightTuning> light_tunings(const std::vector<GroupTuning>& tunings) {
  std::vector<LightTuning> lights;
  for (const GroupTuning& tuning : tunings) lights.push_back({tuning.group->light, &tuning.result});
  return lights;
}

void write_results(const std::filesystem::path& out, const std::vector<GroupTuning>& tunings,
                   const std::vector<LitSum>& sums) {
  create_folder(out);
  const GroupTuning& first = tunings.front();
  const bool is_by_light = !first.group->light.empty();
  const std::filesystem::path preset = out / (stem_of(first, "") + ".toml");
  write_file_atomically(preset,
                        is_by_light ? preset_toml(light_tunings(tunings)) : preset_toml(first.result));
  for (const GroupTuning& tuning : tunings) {
    const std::string& light = tuning.group->light;
    write_file_atomically(out / (stem_of(tuning, light) + "-engine.txt"), engine_block(tuning.result));
    const std::string name = is_by_light ? "tune-" + file_name_of(light) : "tune";
    write_file_atomically(out / (name + ".json"), to_json_text(tuning.result));
  }
  if (is_by_light) write_file_atomically(out / "lights.json", lights_json_text(light_tunings(tunings), sums));
  write_report(out, out / "report.html");
  print_note(fmt::format("wrote {} and {}", preset.string(), (out / "report.html").string()));
}

/// Of every scene with several tuned lights.
std::vector<LitSum> judge_lit_sums(const TuneOptions& options, std::vector<GroupTuning>& tunings,
                                   Renderer& realtime, Progress& progress) {
  std::vector<LitSum> sums;
  for (const std::string& scene : options.scenes) {
    std::vector<TunedLight> lights;
    for (GroupTuning& tuning : tunings) {
      TuneGroup& group = *tuning.group;
      for (size_t i = 0; i < group.jobs.size(); ++i)
        if (group.scenes[i] == scene) lights.push_back({&group.jobs[i], &tuning.plan, &tuning.result});
    }
    if (tunings.size() < 2 || lights.size() < 2) continue;
    if (auto sum = judge_lit_sum(scene, lights, realtime, progress)) sums.push_back(std::move(*sum));
  }
  return sums;
}

GroupTuning tune_group(TuneGroup& group, TunePlan plan, const Home& home, Renderer& realtime,
                       Progress& progress) {
  resolve_lengths(plan, group.jobs);
  plan.is_active = activity(plan, group.jobs, home);
  RenamedProgress renamed(progress, [&](std::string_view task) {
    return (group.light.empty() ? "" : "light " + group.light + ", ") + std::string(task);
  });
  TuneResult result = run_tune(group.jobs, plan, realtime, renamed);
  return {&group, std::move(plan), std::move(result)};
}

std::string answer_of(const std::vector<GroupTuning>& tunings, const std::vector<LitSum>& sums,
                      bool is_json) {
  const GroupTuning& first = tunings.front();
  if (first.group->light.empty())
    return is_json ? to_json_text(first.result) : tune_text(first.plan, first.result);
  if (is_json) return lights_json_text(light_tunings(tunings), sums);
  std::string text;
  for (const GroupTuning& tuning : tunings)
    text += fmt::format("Light {}\n\n{}\n", tuning.group->light, tune_text(tuning.plan, tuning.result));
  return text + lit_sum_text(sums);
}

int tune(const TuneOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_tune_quality(options.quality);
  const Home home = find_home();
  TunePlan plan = make_plan(options, home);
  std::vector<TuneGroup> groups = load_groups(options, plan, scene_search(global, home));
  const std::filesystem::path out = global.out.empty() ? "tuned" : global.out;
  VerbCache cache = open_cache(global, out, !options.no_reuse);
  const auto realtime = open_realtime_renderer(global, home);
  const PictureQuality& picture = quality.picture;
  const PictureQuality coarse = coarse_picture(picture);
  plan.seed = picture.seed;
  plan.kept = {cache.makers(*realtime), &cache.answers()};
  plan.full = {picture.width_px, picture.height_px, &cache.reference(picture)};
  if (!options.no_coarse && coarse.width_px >= kLeastCoarse_px)
    plan.coarse = Fidelity{coarse.width_px, coarse.height_px, &cache.reference(coarse)};
  Renderer& drawn = cache.frames(*realtime, {.keep_runs = false});
  ProgressBar progress;
  std::vector<GroupTuning> tunings;
  for (TuneGroup& group : groups) tunings.push_back(tune_group(group, plan, home, drawn, progress));
  const std::vector<LitSum> sums = judge_lit_sums(options, tunings, drawn, progress);
  progress.clear();
  print_reuse(cache);
  write_results(out, tunings, sums);
  print_answer(answer_of(tunings, sums, global.json));
  return kExitFine;
}

}  // namespace

void add_tune(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<TuneOptions>();
  CLI::App* verb = app.add_subcommand("tune",
                                      "find a technique's best parameters for a scene, or for several at "
                                      "once; writes --out (default tuned/)");
  verb->fallthrough();
  verb->add_option("scene", options->scenes, "library names or scene files")->required();
  verb->add_option("--technique", options->technique,
                   "ID[:name=value,...]: what is not tuned stays as given here")
      ->required();
  verb->add_option("--objective", options->objective,
                   "rmse, penumbra, faults or a metric's key (docs/tuning.md; umbrameter metrics)")
      ->capture_default_str();
  verb->add_option("--parameters", options->parameters,
                   "names, separated by commas; default: all that may be tuned and do not count work")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--time-limit", options->time_limit, "for the whole search of a light, such as 60s")
      ->capture_default_str();
  verb->add_option("--evaluations", options->evaluations,
                   "most parameter sets to try; default 25 + 5 a parameter that acts");
  verb->add_option("--cameras", options->cameras,
                   "5: tune on four cameras beside the scene's, too; 1: on that alone")
      ->check(CLI::IsMember({1, 5}))
      ->capture_default_str();
  verb->add_option("--grid", options->grid,
                   "also try a dense grid of so many steps a number, to check the search")
      ->check(CLI::Range(2, 100));
  verb->add_flag("--no-coarse", options->no_coarse, "never begin with smaller pictures");
  verb->add_flag("--no-reuse", options->no_reuse, "measure again what the store in --out knows");
  verb->add_flag("--together", options->together,
                 "one setting for all lights of a scene; without it each light is tuned by itself");
  add_scene_options(*verb, line.global);
  add_quality_options(*verb, options->quality);
  verb->callback([options, &line] { line.verb = [options, &line] { return tune(*options, line.global); }; });
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/duration.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/quality.h"
#include "cli/scene_options.h"
#include "cli/truth_memory.h"
#include "cli/tune_text.h"
#include "core/error.h"
#include "core/files.h"
#include "realtime/manifest/activity.h"
#include "report/report.h"
#include "results/metadata.h"
#include "study/tune/lengths.h"
#include "study/tune/tune_files.h"
#include "study/tune/tune_json.h"

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

std::vector<SceneJob> load_scenes(const TuneOptions& options, const TunePlan& plan,
                                  const SceneSearch& search) {
  std::vector<SceneJob> jobs;
  for (const std::string& name : options.scenes) {
    for (SceneJob& job : load_scene_jobs(name, search)) {
      if (const auto reason = skip_reason(plan.technique, job.scene))
        fail_input(fmt::format("technique '{}' {}: scene '{}'", plan.technique.id, *reason, job.name));
      jobs.push_back(std::move(job));
    }
  }
  return jobs;
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

void write_results(const std::filesystem::path& out, const TunePlan& plan, const TuneResult& result,
                   const std::string& json) {
  create_folder(out);
  const std::string stem = file_name_of(plan.technique.id);
  write_file_atomically(out / (stem + ".toml"), preset_toml(plan, result));
  write_file_atomically(out / (stem + "-engine.txt"), engine_block(plan, result));
  write_file_atomically(out / "tune.json", json);
  write_report(out, out / "report.html");
  print_note(
      fmt::format("wrote {} and {}", (out / (stem + ".toml")).string(), (out / "report.html").string()));
}

int tune(const TuneOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_tune_quality(options.quality);
  const Home home = find_home();
  TunePlan plan = make_plan(options, home);
  std::vector<SceneJob> scenes = load_scenes(options, plan, scene_search(global, home));
  resolve_lengths(plan, scenes);
  plan.is_active = activity(plan, scenes, home);
  const std::filesystem::path out = global.out.empty() ? "tuned" : global.out;
  TruthMemory memory(global, out, !options.no_reuse);
  const auto realtime = open_realtime_renderer(global, home);
  const PictureQuality& picture = quality.picture;
  const PictureQuality coarse = coarse_picture(picture);
  plan.seed = picture.seed;
  plan.kept = {memory.makers(*realtime), &memory.answers()};
  plan.full = {picture.width_px, picture.height_px, &memory.reference(picture)};
  if (!options.no_coarse && coarse.width_px >= kLeastCoarse_px)
    plan.coarse = Fidelity{coarse.width_px, coarse.height_px, &memory.reference(coarse)};
  ProgressBar progress;
  const TuneResult result = run_tune(scenes, plan, *realtime, progress);
  progress.clear();
  print_reuse(memory);
  const std::string json = to_json_text(plan, result);
  write_results(out, plan, result, json);
  print_answer(global.json ? json : tune_text(plan, result));
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
  verb->add_option("--objective", options->objective, "rmse, penumbra or faults (docs/tuning.md)")
      ->capture_default_str();
  verb->add_option("--parameters", options->parameters,
                   "names, separated by commas; default: all that may be tuned and do not count work")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--time-limit", options->time_limit, "for the whole search, such as 60s")
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
  add_scene_options(*verb, line.global);
  add_quality_options(*verb, options->quality);
  verb->callback([options, &line] { line.verb = [options, &line] { return tune(*options, line.global); }; });
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/progress_bar.h"
#include "cli/reference_renderer.h"
#include "cli/reuse.h"
#include "cli/run_renderer.h"
#include "cli/scene_options.h"
#include "cli/staging.h"
#include "cli/study_runs.h"
#include "cli/sweep_text.h"
#include "cli/sweep_verbs.h"
#include "core/error.h"
#include "lab/stored_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

struct SweepOptions {
  std::string study;
  std::string shard = "1/1";
  std::string metrics;
  bool no_reuse = false;
  bool screen = false;
  bool time = false;
  QualityOptions quality;
};

/// A study loaded and checked, with the renderer whose device its keys name.
struct LoadedSweep {
  std::vector<Quality> qualities;
  SweepPlan plan;  // of any of them, but for its picture
  std::vector<StudyScene> scenes;
  std::unique_ptr<Renderer> realtime;
};

LoadedSweep load(const SweepOptions& options, const GlobalOptions& global, Progress& progress) {
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  const StudyFile study = load_study(options.study);
  LoadedSweep loaded;
  SweepPlan& plan = loaded.plan;
  plan.runs = choose_study_runs(study, options.study, home);
  loaded.qualities = choose_study_qualities(study, options.quality);
  plan.metrics = choose_metrics(options.metrics);
  plan.shard = parse_shard(options.shard);
  plan.reuse = !options.no_reuse;
  if (options.time) plan.timing = {.wanted_frames = study.frames, .budget_s = study.frame_budget_s};
  loaded.scenes = load_study_scenes(study, options.study, search, progress);
  loaded.realtime = open_realtime_renderer(global, home);
  plan.makers = {kReferenceMaker, run_identity(*loaded.realtime), hash_folder(home.shaders)};
  return loaded;
}

/// The object of one quality, or {"qualities": [...]} of several, each with its name.
nlohmann::ordered_json of_qualities(const std::vector<Quality>& qualities, nlohmann::ordered_json all) {
  if (all.size() == 1) return all.front();
  for (size_t i = 0; i < qualities.size(); ++i) all[i]["quality"] = qualities[i].name;
  return {{"qualities", std::move(all)}};
}

int plan(const SweepOptions& options, const GlobalOptions& global) {
  ProgressBar progress;
  LoadedSweep loaded = load(options, global, progress);
  std::unique_ptr<Store> store;
  if (!global.out.empty() && has_store(global.out))
    store = std::make_unique<Store>(global.out, Database::Mode::read);
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Quality& quality : loaded.qualities) {
    loaded.plan.picture = quality.picture;
    const std::vector<PlanStep> steps = plan_sweep(loaded.plan, loaded.scenes, store.get());
    if (store) print_warnings(*store);
    std::vector<IdleParameter> idle;
    if (options.screen)
      idle = screen_parameters(loaded.plan, loaded.scenes, steps, *loaded.realtime, progress);
    if (global.json) {
      all.push_back(plan_json(loaded.plan, loaded.scenes, steps));
      if (options.screen) all.back()["idle_parameters"] = idle_json(idle, loaded.scenes);
      continue;
    }
    print_answer((loaded.qualities.size() > 1 ? quality_heading(quality) : "") +
                 plan_text(loaded.plan, loaded.scenes, steps) +
                 (options.screen ? idle_text(idle, loaded.scenes) : ""));
  }
  if (global.json) print_json(of_qualities(loaded.qualities, std::move(all)));
  return kExitFine;
}

int sweep(const SweepOptions& options, const GlobalOptions& global) {
  if (global.out.empty()) fail_input("a sweep needs a folder to keep its results in", {}, "give --out DIR");
  ProgressBar progress;
  LoadedSweep loaded = load(options, global, progress);
  LazyStore lazy_store(global.out);
  Store& store = lazy_store.store();
  const Staging scratch(std::filesystem::temp_directory_path());
  StoredFrames frames(*loaded.realtime, lazy_store, loaded.plan.makers, hash_of_technique,
                      {.find = !options.no_reuse}, scratch.folder());
  set_interruption_note("interrupted; what was done is stored, the same command goes on from there");
  int code = kExitFine;
  const auto failed = [&](const Failure& failure) {
    progress.clear();
    print_error(failure.message);
    code = std::max(code, exit_code(failure.kind));
  };
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Quality& quality : loaded.qualities) {
    loaded.plan.picture = quality.picture;
    const auto reference = open_reference_renderer(global, quality.picture);
    const std::vector<PlanStep> steps = plan_sweep(loaded.plan, loaded.scenes, &store);
    print_warnings(store);
    const SweepOutcome outcome = run_sweep(loaded.plan, loaded.scenes, steps, {*reference, frames}, store,
                                           scratch.folder(), progress, failed);
    print_warnings(store);
    for (const std::string& reason : outcome.unmeasured) print_error(reason);
    const bool is_all_skipped =
        outcome.rendered + outcome.reused + outcome.not_done == 0 && outcome.skipped > 0;
    if (is_all_skipped && loaded.plan.shard.count == 1)
      print_error("nothing was measured: no run supports its scene's light");
    if (!outcome.unmeasured.empty() || (is_all_skipped && loaded.plan.shard.count == 1))
      code = std::max(code, kExitGateFailed);
    if (global.json) {
      all.push_back(outcome_json(outcome));
    } else {
      print_answer((loaded.qualities.size() > 1 ? quality_heading(quality) : "") + outcome_text(outcome));
    }
  }
  if (const auto line = reused_frames_line(frames.take_reused())) print_note(*line);
  if (global.json) {
    print_json(of_qualities(loaded.qualities, std::move(all)));
  } else {
    print_note(fmt::format("its page: umbrameter report {}", global.out));
  }
  return code;
}

CLI::App* add_study_verb(CLI::App& app, const char* name, const char* what, SweepOptions& options,
                         GlobalOptions& global) {
  CLI::App* verb = app.add_subcommand(name, what);
  verb->fallthrough();
  verb->add_option("study", options.study, "study file (docs/studies.md)")->required();
  add_light_option(*verb, global);
  verb->add_option("--shard", options.shard, "i/n: the i-th of n parts, to be merged afterwards");
  verb->add_option("--metrics", options.metrics, kMetricsHelp);
  verb->add_flag("--no-reuse", options.no_reuse, "render again what is stored");
  verb->add_flag("--time", options.time, "also time frames, in turn with those of the scene's first run");
  verb->add_option("--width", options.quality.width, "picture width in pixels, instead of the study's");
  verb->add_option("--height", options.quality.height, "picture height in pixels, instead of the study's");
  verb->add_option("--spp", options.quality.samples_per_pixel,
                   "reference samples per pixel, instead of the study's");
  return verb;
}

}  // namespace

void add_plan(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* verb = add_study_verb(
      app, "plan", "say what a sweep into --out would render, reuse and skip, why, and how long it takes",
      *options, line.global);
  verb->add_flag("--screen", options->screen, "also name parameters that change no pixel of small pictures");
  verb->callback([options, &line] { line.verb = [options, &line] { return plan(*options, line.global); }; });
}

void add_sweep(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* verb = add_study_verb(
      app, "sweep", "render and score a study's runs into the store --out; goes on where it was stopped",
      *options, line.global);
  verb->callback([options, &line] { line.verb = [options, &line] { return sweep(*options, line.global); }; });
}

}  // namespace umbrameter

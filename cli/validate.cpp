// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/home.h"
#include "cli/interruption.h"
#include "cli/motion_option.h"
#include "cli/positive_number.h"
#include "cli/preset_file.h"
#include "cli/progress_bar.h"
#include "cli/quality.h"
#include "cli/reference_renderer.h"
#include "cli/reuse.h"
#include "cli/run_renderer.h"
#include "cli/scene_options.h"
#include "cli/staging.h"
#include "cli/validation_text.h"
#include "core/error.h"
#include "core/files.h"
#include "core/names.h"
#include "lab/lazy_realtime.h"
#include "lab/scene_cache.h"
#include "lab/stored_frames.h"
#include "lab/validation_cache.h"
#include "report/page_cache.h"
#include "report/report.h"
#include "results/json/results_json.h"
#include "results/measured.h"
#include "results/metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace umbrameter {
namespace {

struct ValidateOptions {
  std::vector<std::string> scenes;
  std::vector<std::string> techniques;
  std::vector<std::string> presets;
  QualityOptions quality;
  std::optional<int> frames;
  std::string metrics;
  std::string baseline;
  std::optional<double> limit_rmse;
  double min_scored = kMinScored;
  std::string causes = "auto";
  std::string motion;
  bool temporal = false;
  bool maps = false;
  bool no_reuse = false;
  bool no_skip = false;
  bool details = false;
};

constexpr int kTemporalFrames = 4;  // of each sequence: three steps show a change, and cost three references

struct Workload {
  std::vector<std::string> names;               // as given
  std::vector<std::vector<SceneSource>> known;  // the views of each name, without what loads them
  std::vector<SceneSource> scenes;              // all the views, each under a name of its own
  std::vector<Skip> skipped;
};

/// Two scene files of one stem get different names, also as folders.
void make_unique(std::string& name, const std::vector<SceneSource>& taken) {
  const std::string stem = name;
  const auto is_taken = [&](const std::string& candidate) {
    return std::any_of(taken.begin(), taken.end(), [&](const SceneSource& source) {
      return file_name_of(source.description.name) == file_name_of(candidate);
    });
  };
  for (int number = 2; is_taken(name); ++number) name = fmt::format("{}-{}", stem, number);
}

/// The library's scenes, less those whose assets are not there.
std::vector<std::string> library_scenes(const SceneSearch& search, std::vector<Skip>& skipped) {
  std::vector<std::string> names;
  for (const SceneEntry& entry : list_scenes(search)) {
    if (entry.missing_assets.empty()) {
      names.push_back(entry.name);
      continue;
    }
    skipped.push_back({entry.name, "",
                       fmt::format("assets not found: {} (give --assets or UMBRAMETER_ASSETS)",
                                   fmt::join(entry.missing_assets, ", "))});
    print_warning(fmt::format("skipped {}: {}", entry.name, skipped.back().reason));
  }
  return names;
}

/// Every scene that is not known is loaded before anything is rendered, so that a bad one costs no time.
Workload open_scenes(const std::vector<std::string>& given, const SceneSearch& search, LazyStore& store,
                     Progress& progress) {
  Workload work;
  work.names = given.empty() ? library_scenes(search, work.skipped) : given;
  progress.begin("loading scenes", work.names.size());
  for (const std::string& name : work.names) {
    work.known.emplace_back();
    for (SceneSource& source : open_scene(store, name, search)) {
      work.known.back().push_back(source);
      work.known.back().back().load = {};
      make_unique(source.description.name, work.scenes);
      work.scenes.push_back(std::move(source));
    }
    progress.advance(1);
  }
  progress.end();
  return work;
}

std::vector<TechniqueRun> choose_techniques(std::vector<std::string> given,
                                            const std::vector<std::string>& preset_files, const Home& home) {
  for (const std::string& file : preset_files)
    given.push_back(fmt::format("{}:preset={}", technique_of_preset(file), file));
  if (given.empty()) return all_techniques(home);
  std::vector<TechniqueRun> runs;
  std::set<std::string> texts;
  std::set<std::string> labels;
  for (const std::string& text : given) {
    if (!texts.insert(text).second) fail_input(fmt::format("technique '{}' is given twice", text));
    std::vector<TechniqueRun> chosen = choose_technique_runs(text, {}, home);
    const bool is_taken = !labels.insert(chosen.front().label).second;
    for (TechniqueRun& run : chosen) {
      if (is_taken) run.label = text;  // a user's copy of a built-in id
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

void check_baseline(const std::string& baseline, const std::vector<TechniqueRun>& techniques) {
  std::vector<std::string> labels;
  for (const TechniqueRun& run : techniques) labels.push_back(run.label);
  if (baseline.empty() || std::ranges::find(labels, baseline) != labels.end()) return;
  fail_input(fmt::format("the baseline '{}' is not among the techniques", baseline), {},
             suggest_name(baseline, labels));
}

ValidationPlan make_plan(const Quality& quality, std::vector<TechniqueRun> techniques,
                         const ValidateOptions& options) {
  ValidationPlan plan;
  plan.quality = quality.name;
  plan.picture = quality.picture;
  plan.timed_frames = options.frames.value_or(quality.timed_frames);
  check_baseline(options.baseline, techniques);
  plan.techniques = std::move(techniques);
  plan.metrics = choose_metrics(options.metrics);
  plan.baseline = options.baseline;
  plan.limit_rmse = options.limit_rmse;
  plan.maps = options.maps;
  plan.motion = options.motion;
  plan.causes = choose_causes(options.causes);
  plan.skip = !options.no_skip;
  return plan;
}

/// Each in its place, the folders instead of the old ones.
void publish(const std::filesystem::path& staged, const std::filesystem::path& out,
             const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::filesystem::is_directory(out / name)) rename_into_place(out / name, staged / ("old-" + name));
  }
  for (const std::string& name : names) {
    if (std::filesystem::exists(staged / name)) rename_into_place(staged / name, out / name);
  }
}

/// Images always: nobody else may have touched them. Numbers and page only when they are not there already: false then.
bool publish_results(const std::filesystem::path& staged, const std::filesystem::path& out,
                     const std::string& json, LazyStore& store) {
  if (is_page_current(store, out, json)) {
    publish(staged, out, {"images"});
    return false;
  }
  write_file_atomically(staged / "results.json", json);
  write_report(staged, staged / "report.html", kPageBudget_bytes, out);
  publish(staged, out, {"images", "results.json", "report-data", "report.html"});
  if (store.exists()) keep_page(store, out, json);
  return true;
}

/// Of the whole library, scenes that no chosen technique supports are skipped as said, as long as one was measured.
bool is_expected_skip(const ValidateOptions& options, const Results& results, const SceneResult& scene) {
  if (!options.scenes.empty() || !scene.techniques.empty()) return false;
  const bool is_whole_scene = std::ranges::any_of(
      results.skipped, [&](const Skip& skip) { return skip.scene == scene.name && skip.technique.empty(); });
  return !is_whole_scene;
}

/// Sentences for what was not measured.
std::vector<std::string> unmeasured_of(const ValidateOptions& options, const Results& results) {
  std::vector<MeasuredScene> asked = measured_scenes(results);
  size_t index = 0;
  std::erase_if(asked, [&](const MeasuredScene&) {
    return is_expected_skip(options, results, results.scenes[index++]);
  });
  return unmeasured(asked, options.min_scored);
}

int verdict(const ValidateOptions& options, const Results& results) {
  int code = parity_passes(results) && !exceeds_limit(results) ? kExitFine : kExitGateFailed;
  if (exceeds_limit(results)) print_error("at least one technique exceeds --limit");
  for (const Failure& failure : all_failures(results)) {
    print_error(failure.message);
    code = std::max(code, exit_code(failure.kind));
  }
  if (!parity_passes(results))
    print_error("the renderers disagree on at least one scene; its numbers are void");
  for (const std::string& reason : unmeasured_of(options, results)) {
    print_error(reason);
    code = std::max(code, kExitGateFailed);
  }
  return code;
}

bool has_any_result(const Results& results) {
  return std::any_of(results.scenes.begin(), results.scenes.end(),
                     [](const SceneResult& scene) { return scene.reference.has_value(); });
}

int validate(const ValidateOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_quality(options.quality);
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  ValidationPlan plan =
      make_plan(quality, choose_techniques(options.techniques, options.presets, home), options);
  plan.temporal_frames = options.temporal ? kTemporalFrames : 0;
  const std::filesystem::path out = global.out.empty() ? "out" : global.out;
  check_results_folder(out);
  const Staging staging(out);
  LazyStore store(out);
  LazyRealtime realtime(
      store,
      {global.device, [&] { return open_realtime_renderer(global, home, !options.no_skip); }, run_identity});
  LazyRenderer reference([&] { return open_reference_renderer(global, quality.picture, !options.no_skip); });
  const Makers makers{kReferenceMaker, realtime.identity(), hash_folder(home.shaders)};
  ValidationCache cache(store, makers, !options.no_reuse);
  StoredFrames frames(realtime.renderer(), store, makers, hash_of_technique,
                      {.keep_runs = false, .keep_surfaces = false}, staging.folder());
  const bool draws_all = options.no_reuse || options.no_skip;
  ProgressBar progress;
  Workload work = open_scenes(options.scenes, search, store, progress);
  print_warnings(store.take_warnings());
  if (work.scenes.empty()) fail_input("no scene is left to validate");
  Results results = run_validation(
      work.scenes, plan, {reference, draws_all ? realtime.renderer() : frames}, staging.folder(), progress,
      [&](const SceneResult& scene) {
        progress.clear();
        print_warnings(store.take_warnings());
        print_note(scene_line(scene));
        if (store.exists())
          set_interruption_note("interrupted; finished scenes are stored, go on with the same command");
      },
      &cache);
  results.skipped.insert(results.skipped.begin(), work.skipped.begin(), work.skipped.end());
  const int code = verdict(options, results);
  if (!has_any_result(results)) {  // nothing worth replacing an earlier result with
    print_answer(global.json ? to_json_text_with_work(results) : validation_text(results, options.details));
    return code;
  }
  if (store.exists()) realtime.keep_identity();
  for (size_t i = 0; store.exists() && i < work.names.size(); ++i)
    keep_scene(store, work.names[i], search, work.known[i]);
  const bool is_new = publish_results(staging.folder(), out, to_json_text(results), store);
  print_answer(global.json ? to_json_text_with_work(results) : validation_text(results, options.details));
  print_note(work_line(results.work));
  if (const auto line = reused_frames_line(frames.take_reused())) print_note(*line);
  const std::string page = (out / "report.html").string();
  print_note(is_new ? fmt::format("wrote {}", page) : fmt::format("{} is of these results already", page));
  return code;
}

}  // namespace

void add_validate(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* verb =
      app.add_subcommand("validate", "measure techniques against the truth; writes --out (default out/)");
  verb->fallthrough();
  verb->add_option("scene", options->scenes, "library names or scene files; none = the whole library");
  verb->add_option(
          "--technique", options->techniques,
          "ID[:name=value,...], ID may be a folder, preset=NAME chooses a preset; repeatable; none = all")
      ->allow_extra_args(false);
  verb->add_option("--preset", options->presets,
                   "a file that 'tune' wrote: its technique with its values; repeatable")
      ->allow_extra_args(false);
  verb->add_option("--baseline", options->baseline,
                   "label of the technique that verdicts compare with (default: hard, else the first)");
  verb->add_option("--limit", options->limit_rmse,
                   "RMSE that techniques must keep; exit code 1 when one does not")
      ->check(positive_number());
  verb->add_option("--min-scored", options->min_scored,
                   "share of the pixels that the truth can score that must be scored, else exit code 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--metrics", options->metrics, kMetricsHelp);
  verb->add_flag("--maps", options->maps, kMapsHelp);
  verb->add_option(
          "--causes", options->causes,
          "draw runs again with one thing replaced by the truth or its limit, and say what mends their "
          "faults: none, auto (the three worst of a scene, where it takes less time than the scene), worst "
          "(the three), all")
      ->capture_default_str();
  add_scene_options(*verb, line.global);
  add_quality_options(*verb, options->quality);
  verb->add_option("--frames", options->frames,
                   "timed frames per technique, instead of the quality's; 0 times nothing")
      ->check(CLI::Range(0, 10000));
  add_motion_option(*verb, options->motion);
  verb->add_flag("--temporal", options->temporal,
                 "also measure flicker under a moving camera and light, and the noise of seeds");
  verb->add_flag("--no-reuse", options->no_reuse, "render and score again what the store in --out knows");
  verb->add_flag("--no-skip", options->no_skip,
                 "do what the scenes do not need, too; the numbers are the same");
  verb->add_flag("--details", options->details,
                 "also print parity, significance, verdicts and left-out passes of every run");
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return validate(*options, line.global); }; });
}

}  // namespace umbrameter

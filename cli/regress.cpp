// SPDX-License-Identifier: Apache-2.0
#include "results/regress/update.h"
#include "study/regress/run.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/regress_prove.h"
#include "cli/reuse.h"
#include "cli/staging.h"
#include "cli/study_runs.h"
#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "lab/validation_cache.h"
#include "report/regress_output.h"
#include "report/report.h"
#include "results/json/results_json.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace umbrameter {
namespace {

struct RegressOptions {
  std::string suite;
  std::string baseline_folder;
  std::string junit, annotate, report, reason;
  bool update = false, no_reuse = false;
  std::optional<uint64_t> seed;
  std::vector<std::string> proof_scenes;
};

/// A suite with all it names, loaded and checked before anything is rendered.
struct LoadedSuite {
  RegressPlan plan;
  Quality quality;
  std::vector<SceneJob> scenes;
  std::filesystem::path baseline_file;
};

LoadedSuite load(const RegressOptions& options, const GlobalOptions& global, const Home& home,
                 Progress& progress) {
  const std::filesystem::path file = options.suite;
  const RegressSuite suite = load_suite(file);
  LoadedSuite loaded;
  if (suite.study.qualities.size() > 1)
    fail_input(fmt::format("a suite takes one quality, not {}", suite.study.qualities.size()),
               suite.study.where);
  loaded.quality = choose_study_qualities(suite.study, {}).front();
  RegressPlan& plan = loaded.plan;
  plan.suite = file.stem().string();
  plan.picture = loaded.quality.picture;
  plan.picture.seed = options.seed.value_or(plan.picture.seed);
  const int samples = plan.picture.samples_per_pixel;
  plan.most_samples_per_pixel = suite.most_samples_per_pixel > 0 ? suite.most_samples_per_pixel : 4 * samples;
  if (plan.most_samples_per_pixel < samples)
    fail_input(fmt::format("'most_samples_per_pixel' is {}, less than the {} that every case gets",
                           plan.most_samples_per_pixel, samples),
               suite.study.where);
  plan.gates = suite.gates;
  if (plan.gates.time_ratio) plan.timed_frames = suite.study.frames;
  plan.timing_budget_s = suite.study.frame_budget_s;
  for (const BenchRun& run : choose_study_runs(suite.study, file, home)) plan.runs.push_back(run.technique);
  for (StudyScene& scene : load_study_scenes(suite.study, file, scene_search(global, home), progress))
    loaded.scenes.push_back({full_name(scene), std::move(scene.scene)});
  loaded.baseline_file = std::filesystem::path(options.baseline_folder) / (plan.suite + ".toml");
  return loaded;
}

RegressRenderers renderers_of(Renderer& realtime, VerbCache& cache, const PictureQuality& picture) {
  const auto make_reference = [&cache, picture](int samples) {
    PictureQuality part = picture;
    part.samples_per_pixel = samples;
    part.target_se.reset();
    return std::shared_ptr<Renderer>(std::shared_ptr<void>(), &cache.reference(part));
  };
  return {cache.frames(realtime), make_reference, cache.makers(realtime), &cache.answers()};
}

BaselineReason reason_of(const std::string& text) {
  return {fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))), text, kVersion, {}};
}

int report_voids(const RegressResults& measured) {
  for (const RegressCase& one : measured.cases) {
    if (!one.now) print_error(fmt::format("{}, {}: {}", one.scene, one.label, one.verdict.message));
  }
  return measured.passes() ? kExitFine : kExitGateFailed;
}

void write_baseline(const std::filesystem::path& file, const Baseline& baseline) {
  create_folder(file.parent_path());
  write_file_atomically(file, to_toml_text(baseline));
  print_note(fmt::format("wrote {}", file.string()));
}

int record(const RegressOptions& options, const GlobalOptions& global) {
  require_store(options.no_reuse, global);
  ProgressBar progress;
  const Home home = find_home();
  const LoadedSuite suite = load(options, global, home, progress);
  const bool is_there = std::filesystem::exists(suite.baseline_file);
  if (is_there && options.reason.empty())
    fail_input("the baseline is there already", {suite.baseline_file.string()},
               "'regress check --update --reason TEXT' changes it, 'regress record --reason TEXT' makes all "
               "of it anew");
  const auto realtime = open_realtime_renderer(global, home);
  VerbCache cache = open_cache(global, global.out, !options.no_reuse);
  const RegressResults measured =
      measure_suite(suite.scenes, suite.plan, renderers_of(*realtime, cache, suite.plan.picture), progress);
  print_reuse(cache);
  const int code = report_voids(measured);
  if (code != kExitFine) return code;
  const std::string reason = options.reason.empty() ? "recorded for the first time" : options.reason;
  Baseline baseline = baseline_of(measured, reason_of(reason));
  if (is_there) {
    const Baseline old = load_baseline(suite.baseline_file);
    baseline.reasons.insert(baseline.reasons.begin(), old.reasons.begin(), old.reasons.end());
  }
  write_baseline(suite.baseline_file, baseline);
  print_answer(global.json ? regress_json(measured) : regress_text(measured));
  return kExitFine;
}

/// Only what has changed is measured with the care of a record.
void update(const LoadedSuite& suite, const RegressOptions& options, const Baseline& baseline,
            const RegressResults& checked, const RegressRenderers& renderers, Progress& progress) {
  std::vector<SceneJob> changed;
  for (const SceneJob& job : suite.scenes) {
    const auto is_of_scene = [&](const RegressCase& one) {
      return one.scene == job.name && one.has_changed() && one.verdict.kind != "stale";
    };
    if (std::ranges::any_of(checked.cases, is_of_scene)) changed.push_back(job);
  }
  const RegressResults measured = measure_suite(changed, suite.plan, renderers, progress);
  const Baseline fresh = updated(baseline, checked, measured, reason_of(options.reason));
  if (fresh.reasons.size() == baseline.reasons.size()) {
    print_note("nothing has changed, so the baseline stays as it is");
    return;
  }
  write_baseline(suite.baseline_file, fresh);
}

/// Before and after, as a table for people or as a page without pictures.
void write_table(const std::filesystem::path& file, const RegressResults& checked) {
  if (file.extension() == ".md") return write_file_atomically(file, regress_markdown(checked));
  const Staging staging(std::filesystem::temp_directory_path());
  write_file_atomically(staging.folder() / "regress.json", regress_json(checked));
  write_report(staging.folder(), file);
}

/// The same runs as 'validate' shows them: pictures, faults, everything in results.json, and before and after.
void write_results_folder(const LoadedSuite& suite, Renderer& realtime, VerbCache& cache,
                          const RegressOptions& options, const GlobalOptions& global,
                          const RegressResults& checked, Progress& progress) {
  ValidationPlan plan;
  plan.quality = suite.quality.name;
  plan.picture = suite.plan.picture;
  plan.timed_frames = suite.plan.timed_frames;
  plan.techniques = suite.plan.runs;
  ValidationCache runs(*cache.store(), cache.makers(realtime), !options.no_reuse);
  std::vector<SceneSource> sources;
  for (const SceneJob& job : suite.scenes) sources.push_back(source_of(job));
  const Results results =
      run_validation(sources, plan, {cache.reference(plan.picture), cache.frames(realtime)}, global.out,
                     progress, {}, &runs);
  const std::filesystem::path out = global.out;
  write_file_atomically(out / "results.json", to_json_text(results));
  write_file_atomically(out / "regress.json", regress_json(checked));
  write_report(out, out / "report.html");
  print_note(fmt::format("wrote {}", (out / "report.html").string()));
}

/// Runs without numbers, which no update can accept.
bool has_void(const RegressResults& checked) {
  bool found = false;
  for (const RegressCase& one : checked.cases) {
    const bool is_void = !one.now && one.verdict.kind != "stale" && one.label != kTruthLabel;
    if (is_void) print_error(fmt::format("{}, {}: {}", one.scene, one.label, one.verdict.message));
    found = found || is_void;
  }
  return found;
}

void check_options(const RegressOptions& options, const GlobalOptions& global) {
  if (options.update && options.reason.empty())
    fail_input("--update needs --reason", {}, "say why the new numbers are right; the baseline keeps it");
  if (!options.update && !options.reason.empty())
    fail_input("--reason is given without --update", {}, "a check changes nothing");
  require_store(options.no_reuse, global);
  if (!options.annotate.empty() && global.json)
    fail_input("--annotate and --json both want the standard output", {}, "--junit writes to a file");
  const std::filesystem::path report = options.report;
  if (!report.empty() && report.extension() != ".html" && report.extension() != ".md")
    fail_input(fmt::format("the report '{}' ends neither in .html nor in .md", options.report));
}

int check_suite(const RegressOptions& options, const GlobalOptions& global) {
  check_options(options, global);
  ProgressBar progress;
  const Home home = find_home();
  const LoadedSuite suite = load(options, global, home, progress);
  if (!std::filesystem::exists(suite.baseline_file))
    fail_input("there is no baseline", {suite.baseline_file.string()},
               "make one with 'umbrameter regress record'");
  const Baseline baseline = load_baseline(suite.baseline_file);
  const auto realtime = open_realtime_renderer(global, home);
  VerbCache cache = open_cache(global, global.out, !options.no_reuse);
  const RegressRenderers renderers = renderers_of(*realtime, cache, suite.plan.picture);
  const RegressResults results = check_suite(suite.scenes, suite.plan, baseline, renderers, progress);
  if (!options.junit.empty()) write_file_atomically(options.junit, junit_xml(results));
  if (!options.report.empty()) write_table(options.report, results);
  if (!global.out.empty()) write_results_folder(suite, *realtime, cache, options, global, results, progress);
  print_reuse(cache);
  print_answer(global.json ? regress_json(results) : regress_text(results));
  if (!options.annotate.empty()) print_answer(github_annotations(results));
  if (options.update) {
    update(suite, options, baseline, results, renderers, progress);
    return has_void(results) ? kExitGateFailed : kExitFine;
  }
  if (results.passes()) return kExitFine;
  print_error(fmt::format("{} of {} cases fail", results.count(CaseOutcome::fail), results.cases.size()));
  return kExitGateFailed;
}

int prove(const RegressOptions& options, const GlobalOptions& global) {
  return prove_regress(options.proof_scenes, global);
}

using Verb = int (*)(const RegressOptions&, const GlobalOptions&);

CLI::App* add_part(CLI::App& verb, CommandLine& line, const std::shared_ptr<RegressOptions>& options,
                   const char* name, const char* doc, Verb run) {
  CLI::App* part = verb.add_subcommand(name, doc);
  part->fallthrough();
  part->callback(
      [options, run, &line] { line.verb = [options, run, &line] { return run(*options, line.global); }; });
  return part;
}

void add_suite_options(CLI::App& part, RegressOptions& options) {
  part.add_option("suite", options.suite, "suite file (docs/regress.md)")->required();
  part.add_option("--baseline", options.baseline_folder,
                  "folder of the baselines; <suite>.toml is read and written there")
      ->required();
  part.add_option("--seed", options.seed, "seed of all sampling, instead of the suite's");
  part.add_flag("--no-reuse", options.no_reuse, "measure again what the store in --out knows");
}

}  // namespace

void add_regress(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<RegressOptions>();
  CLI::App* verb = app.add_subcommand(
      "regress", "keep techniques as right as they were: record numbers, check against them");
  verb->fallthrough();
  verb->require_subcommand(1);
  CLI::App* record_part =
      add_part(*verb, line, options, "record", "measure a suite and write its baseline", record);
  add_suite_options(*record_part, *options);
  record_part->add_option("--reason", options->reason, "why a baseline that is there is made anew");
  CLI::App* check_part = add_part(*verb, line, options, "check",
                                  "measure a suite and judge it; exit code 1 when a case fails", check_suite);
  add_suite_options(*check_part, *options);
  check_part->add_option("--junit", options->junit, "also write JUnit XML to this file");
  check_part->add_option("--annotate", options->annotate, "also print annotations for a CI server")
      ->check(CLI::IsMember({"github"}));
  check_part->add_option("--report", options->report, "also write a table of before and after: .html or .md");
  check_part->add_flag("--update", options->update,
                       "take what has changed into the baseline; needs --reason");
  check_part->add_option("--reason", options->reason, "why it may change; kept in the baseline");
  CLI::App* prove_part = add_part(*verb, line, options, "prove",
                                  "record and check the selftest's faults: each must be found", prove);
  prove_part->add_option("--scene", options->proof_scenes, "only this scene's faults; repeatable")
      ->allow_extra_args(false);
}

}  // namespace umbrameter

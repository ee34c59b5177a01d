// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_text.h"
#include "cli/console.h"
#include "cli/duration.h"
#include "cli/progress_bar.h"
#include "cli/reuse.h"
#include "cli/scene_options.h"
#include "cli/staging.h"
#include "cli/study_runs.h"
#include "core/error.h"
#include "core/files.h"
#include "reference/reference.h"
#include "report/report.h"
#include "results/json/schemas.h"
#include "results/measured.h"
#include "results/metadata.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

struct BenchOptions {
  std::vector<std::string> studies;
  std::string csv;
  std::string truth_csv;
  std::string best_under;
  std::optional<double> cheapest_below_rmse;
  std::optional<int> frames;
  bool with_passes = false;
  bool no_reuse = false;
  QualityOptions quality;
};

BenchQueries choose_queries(const BenchOptions& options) {
  BenchQueries queries;
  if (!options.best_under.empty()) queries.best_under_ms = milliseconds("--best-under", options.best_under);
  queries.cheapest_below_rmse = options.cheapest_below_rmse;
  if (queries.cheapest_below_rmse && !(*queries.cheapest_below_rmse > 0.0))
    fail_input(fmt::format("--cheapest-below-rmse is {}, not positive", *queries.cheapest_below_rmse));
  return queries;
}

BenchPlan make_plan(const StudyFile& study, const std::string& file, const Quality& quality,
                    const BenchOptions& options, const Home& home) {
  BenchPlan plan;
  plan.title = study.title;
  plan.doc = study.doc;
  plan.file = file;
  plan.quality = quality.name;
  plan.picture = quality.picture;
  plan.timing = {.wanted_frames = options.frames.value_or(study.frames), .budget_s = study.frame_budget_s};
  plan.runs = choose_study_runs(study, file, home);
  plan.claims = study.claims;
  return plan;
}

int verdict(const BenchResults& results) {
  int code = kExitFine;
  for (const Failure& failure : all_failures(results)) {
    print_error(failure.message);
    code = std::max(code, exit_code(failure.kind));
  }
  for (const std::string& reason : unmeasured(measured_scenes(results))) {
    print_error(reason);
    code = std::max(code, kExitGateFailed);
  }
  return code;
}

/// One study, loaded and checked, so that a bad one costs no time.
struct LoadedStudy {
  std::vector<BenchPlan> plans;  // one a quality
  std::vector<StudyScene> scenes;
};

LoadedStudy load(const std::string& file, const BenchOptions& options, const Home& home,
                 const SceneSearch& search, Progress& progress) {
  const StudyFile study = load_study(file);
  LoadedStudy loaded;
  for (const Quality& quality : choose_study_qualities(study, options.quality))
    loaded.plans.push_back(make_plan(study, file, quality, options, home));
  loaded.scenes = load_study_scenes(study, file, search, progress);
  return loaded;
}

/// The last target judges the others (lab/truth_curve.h); its sample limit is out of reach for all but thin things.
TruthPlan make_truth_plan(int threads) {
  TruthPlan plan;
  std::vector<ReferenceSettings> settings;
  const auto add = [&](const std::string& kind, double setting, int samples,
                       std::optional<double> target_se) {
    settings.push_back({samples, target_se, threads, true, false});
    plan.settings.push_back({kind, setting, nullptr});
  };
  for (const double target : {0.02, 0.01, 0.005, 0.002}) add("target_se", target, 1 << 16, target);
  for (const int samples : {32, 128, 512, 2048}) add("samples", samples, samples, {});
  auto renderers = make_reference_renderers(settings);
  for (size_t i = 0; i < renderers.size(); ++i) plan.settings[i].renderer = std::move(renderers[i]);
  return plan;
}

BenchResults run(const BenchPlan& plan, std::span<const StudyScene> scenes, Renderer& realtime,
                 VerbCache& cache, BenchCache* kept, const TruthPlan& truth, ProgressBar& progress) {
  ReusedTruths all;
  std::vector<Skip> skipped;
  const auto scene_done = [&](const BenchScene& scene) {
    progress.clear();
    print_warnings(cache.take_warnings());
    print_note(scene_line(scene));
    const ReusedTruths reused = cache.take_reused();
    if (reused.count > 0) skipped.push_back({scene.name, "", "its truth is stored", reused.saved_s});
    all += reused;
  };
  BenchResults results = run_bench(scenes, plan, {cache.reference(plan.picture), cache.frames(realtime)},
                                   progress, scene_done, truth, kept);
  results.skipped.insert(results.skipped.end(), skipped.begin(), skipped.end());
  if (all.count > 0) print_note(reused_line(all));
  return results;
}

void require_one_table(const BenchOptions& options, const std::vector<LoadedStudy>& studies) {
  const bool has_one = studies.size() == 1 && studies.front().plans.size() == 1;
  for (const auto& [option, file] : {std::pair("--csv", &options.csv), {"--truth", &options.truth_csv}}) {
    if (file->empty() || has_one) continue;
    fail_input(fmt::format("{} takes one study of one quality, as each has a table of its own", option), {},
               "run them one by one");
  }
}

/// One object, or {"studies": [...]} of several studies or qualities.
std::string json_of(const std::vector<BenchResults>& all, const BenchQueries& queries) {
  if (all.size() == 1) return to_json_text(all.front(), queries);
  std::string text;
  for (const BenchResults& results : all) {
    std::string one = to_json_text(results, queries);
    while (one.ends_with('\n')) one.pop_back();
    text += (text.empty() ? "" : ",\n") + one;
  }
  return fmt::format("{{\"schema\": {}, \"studies\": [\n{}\n]}}\n", kBenchSchema.number, text);
}

/// The numbers beside the truths, and the page of all that lies there.
void write_page(const std::filesystem::path& out, const std::filesystem::path& study,
                const std::string& json) {
  create_folder(out);
  write_file_atomically(out / fmt::format("bench-{}.json", file_name_of(study.stem().string())), json);
  write_report(out, out / "report.html");
  print_note(fmt::format("wrote {}", (out / "report.html").string()));
}

int bench(const BenchOptions& options, const GlobalOptions& global) {
  const BenchQueries queries = choose_queries(options);
  require_store(options.no_reuse, global);
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  std::optional<StagedFile> csv;
  if (!options.csv.empty()) csv.emplace(options.csv, ".csv");
  std::optional<StagedFile> truth_file;
  if (!options.truth_csv.empty()) truth_file.emplace(options.truth_csv, ".csv");
  ProgressBar progress;
  std::vector<LoadedStudy> studies;
  for (const std::string& file : options.studies)
    studies.push_back(load(file, options, home, search, progress));
  require_one_table(options, studies);
  VerbCache cache = open_cache(global, global.out, !options.no_reuse);
  const auto realtime = open_realtime_renderer(global, home);
  std::optional<BenchCache> kept;
  if (cache.store() != nullptr)
    kept.emplace(BenchCache{*cache.store(), cache.answers(), cache.makers(*realtime), !options.no_reuse,
                            cache.scratch()});
  const TruthPlan truth = truth_file ? make_truth_plan(global.threads) : TruthPlan{};
  std::vector<BenchResults> all;
  int code = kExitFine;
  for (LoadedStudy& study : studies) {
    for (const BenchPlan& plan : study.plans) {
      all.push_back(run(plan, study.scenes, *realtime, cache, kept ? &*kept : nullptr, truth, progress));
      if (!global.json) print_answer(bench_text(all.back(), queries, options.with_passes));
      code = std::max(code, verdict(all.back()));
    }
    study.scenes.clear();
  }
  if (csv) {
    write_file_atomically(csv->staged(), to_csv(all.front()));
    csv->publish();
  }
  if (truth_file) {
    write_file_atomically(truth_file->staged(), truth_csv(all.front()));
    truth_file->publish();
  }
  if (!global.out.empty()) write_page(global.out, options.studies.front(), json_of(all, queries));
  if (global.json) print_answer(json_of(all, queries));
  return code;
}

}  // namespace

void add_bench(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* verb =
      app.add_subcommand("bench",
                         "time a study's runs in turn, score them, and set them beside a paper's "
                         "claims; with --out keeps all of it there, reuses it, and leaves a page");
  verb->fallthrough();
  verb->add_option("study", options->studies, "study files (docs/studies.md)")->required();
  add_light_option(*verb, line.global);
  verb->add_option("--csv", options->csv, "also write one line a scene and run to this file");
  verb->add_option("--truth", options->truth_csv,
                   "also measure time against error of the truth, one line a scene and setting to this file");
  verb->add_option("--best-under", options->best_under, "name the smallest error within a time, such as 1ms");
  verb->add_option("--cheapest-below-rmse", options->cheapest_below_rmse,
                   "name the shortest time below an RMSE");
  verb->add_flag("--passes", options->with_passes, "also print the time of every pass");
  verb->add_flag("--no-reuse", options->no_reuse, "measure again what the store in --out knows");
  verb->add_option("--frames", options->frames, "timed frames per run, instead of the study's")
      ->check(CLI::Range(1, 10000));
  verb->add_option("--width", options->quality.width, "picture width in pixels, instead of the study's");
  verb->add_option("--height", options->quality.height, "picture height in pixels, instead of the study's");
  verb->add_option("--spp", options->quality.samples_per_pixel,
                   "reference samples per pixel, instead of the study's");
  verb->callback([options, &line] { line.verb = [options, &line] { return bench(*options, line.global); }; });
}

}  // namespace umbrameter

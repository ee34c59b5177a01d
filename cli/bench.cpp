#include "cli/bench_text.h"
#include "cli/console.h"
#include "cli/progress_bar.h"
#include "cli/staging.h"
#include "cli/study_runs.h"
#include "core/error.h"
#include "core/files.h"
#include "reference/reference.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace umbrameter {
namespace {

struct BenchOptions {
  std::string study;
  std::string csv;
  std::string best_under;
  std::optional<double> cheapest_below_rmse;
  std::optional<int> frames;
  bool with_passes = false;
  QualityOptions quality;
};

/// "1ms", "800us", "0.5 s".
double milliseconds(const std::string& text) {
  struct Unit {
    std::string_view name;
    double ms;
  };
  constexpr std::array<Unit, 3> kUnits{{{"ms", 1.0}, {"us", 1e-3}, {"s", 1e3}}};
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string_view unit(end, static_cast<size_t>(text.data() + text.size() - end));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  for (const Unit& known : kUnits) {
    if (problem == std::errc() && unit == known.name && std::isfinite(value) && value > 0.0)
      return value * known.ms;
  }
  fail_input(fmt::format("--best-under is '{}', not a time", text), {},
             "a number with its unit, such as 1ms");
}

BenchQueries choose_queries(const BenchOptions& options) {
  BenchQueries queries;
  if (!options.best_under.empty()) queries.best_under_ms = milliseconds(options.best_under);
  queries.cheapest_below_rmse = options.cheapest_below_rmse;
  if (queries.cheapest_below_rmse && !(*queries.cheapest_below_rmse > 0.0))
    fail_input(fmt::format("--cheapest-below-rmse is {}, not positive", *queries.cheapest_below_rmse));
  return queries;
}

BenchPlan make_plan(const StudyFile& study, const Quality& quality, const BenchOptions& options,
                    const Home& home) {
  BenchPlan plan;
  plan.title = study.title;
  plan.doc = study.doc;
  plan.file = options.study;
  plan.quality = quality.name;
  plan.width_px = quality.width_px;
  plan.height_px = quality.height_px;
  plan.samples_per_pixel = quality.samples_per_pixel;
  plan.target_se = quality.target_se;
  plan.reference_seed = quality.seed;
  plan.timing = {.wanted_frames = options.frames.value_or(study.frames), .budget_s = study.frame_budget_s};
  plan.runs = choose_study_runs(study, options.study, home);
  plan.claims = study.claims;
  return plan;
}

int verdict(const BenchResults& results) {
  int code = kExitFine;
  for (const Failure& failure : all_failures(results)) {
    print_error(failure.message);
    code = std::max(code, exit_code(failure.kind));
  }
  return code;
}

int bench(const BenchOptions& options, const GlobalOptions& global) {
  const StudyFile study = load_study(options.study);
  const Quality quality = choose_study_quality(study, options.quality);
  const BenchQueries queries = choose_queries(options);
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  const BenchPlan plan = make_plan(study, quality, options, home);
  std::optional<StagedFile> csv;
  if (!options.csv.empty()) csv.emplace(options.csv, ".csv");
  ProgressBar progress;
  const std::vector<SceneJob> scenes = load_study_scenes(study, options.study, search, progress);
  const auto realtime = open_realtime_renderer(global, home);
  const auto reference =
      make_reference_renderer({quality.samples_per_pixel, quality.target_se, global.threads});
  const BenchResults results =
      run_bench(scenes, plan, {*reference, *realtime}, progress, [&](const BenchScene& scene) {
        progress.clear();
        print_note(scene_line(scene));
      });
  if (csv) {
    write_file_atomically(csv->staged(), to_csv(results));
    csv->publish();
  }
  print_answer(global.json ? to_json_text(results, queries)
                           : bench_text(results, queries, options.with_passes));
  return verdict(results);
}

}  // namespace

void add_bench(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* verb = app.add_subcommand(
      "bench", "time a study's runs in turn, score them, and set them beside a paper's claims");
  verb->fallthrough();
  verb->add_option("study", options->study, "study file (docs/studies.md)")->required();
  verb->add_option("--csv", options->csv, "also write one line a scene and run to this file");
  verb->add_option("--best-under", options->best_under, "name the smallest error within a time, such as 1ms");
  verb->add_option("--cheapest-below-rmse", options->cheapest_below_rmse,
                   "name the shortest time below an RMSE");
  verb->add_flag("--passes", options->with_passes, "also print the time of every pass");
  verb->add_option("--frames", options->frames, "timed frames a run, instead of the study's")
      ->check(CLI::Range(1, 10000));
  verb->add_option("--width", options->quality.width, "picture width in pixels, instead of the study's");
  verb->add_option("--height", options->quality.height, "picture height in pixels, instead of the study's");
  verb->add_option("--spp", options->quality.samples_per_pixel,
                   "reference samples a pixel, instead of the study's");
  verb->callback([options, &line] { line.verb = [options, &line] { return bench(*options, line.global); }; });
}

}  // namespace umbrameter

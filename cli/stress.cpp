// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/exact_program.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/reuse.h"
#include "cli/run_renderer.h"
#include "cli/staging.h"
#include "cli/stress_worker.h"
#include "cli/verbs.h"
#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "report/report.h"
#include "report/stress_output.h"
#include "study/stress/axes.h"
#include "study/stress/suite_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

struct StressOptions {
  std::string suite;
  std::vector<std::string> techniques, axes;
  std::optional<int> width_px, height_px, samples_per_pixel, timeout_s;
  std::optional<uint64_t> seed;
  bool markdown = false, keep_pictures = false, no_reuse = false;
  std::string worker_axis, worker_folder;  // set for workers alone
};

/// The plan's axes of these names; built-in ones where the plan has none.
std::vector<StressAxis> chosen_axes(const StressPlan& plan, const std::vector<std::string>& names) {
  std::vector<StressAxis> axes;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(plan.axes, name, &StressAxis::name);
    axes.push_back(found != plan.axes.end() ? *found : find_stress_axis(name));
  }
  return axes;
}

StressPlan plan_of(const StressOptions& options) {
  StressPlan plan = options.suite.empty() ? full_stress_plan() : load_stress_suite(options.suite);
  plan.picture.width_px = options.width_px.value_or(plan.picture.width_px);
  plan.picture.height_px = options.height_px.value_or(plan.picture.height_px);
  plan.picture.samples_per_pixel = options.samples_per_pixel.value_or(plan.picture.samples_per_pixel);
  plan.timeout_s = options.timeout_s.value_or(plan.timeout_s);
  plan.picture.seed = options.seed.value_or(plan.picture.seed);
  if (!options.techniques.empty()) plan.techniques = options.techniques;
  if (!options.axes.empty()) plan.axes = chosen_axes(plan, options.axes);
  return plan;
}

/// What makes a worker read the same plan, and take one axis of it.
std::vector<std::string> worker_arguments(const StressOptions& options, const GlobalOptions& global,
                                          const StressPlan& plan, const StressAxis& axis,
                                          const std::filesystem::path& folder) {
  std::vector<std::string> arguments = {"stress"};
  const auto add = [&](const std::string& name, const std::string& value) {
    arguments.insert(arguments.end(), {name, value});
  };
  if (!options.suite.empty()) arguments.push_back(options.suite);
  for (const std::string& technique : options.techniques) add("--technique", technique);
  add("--width", std::to_string(plan.picture.width_px));
  add("--height", std::to_string(plan.picture.height_px));
  add("--spp", std::to_string(plan.picture.samples_per_pixel));
  add("--seed", std::to_string(plan.picture.seed));
  add("--threads", std::to_string(global.threads));
  if (!global.device.empty()) add("--device", global.device);
  if (!global.out.empty()) add("--out", std::filesystem::absolute(global.out).string());
  if (options.keep_pictures) arguments.push_back("--pictures");
  if (options.no_reuse) arguments.push_back("--no-reuse");
  add("--worker-axis", axis.name);
  add("--worker-folder", folder.string());
  return arguments;
}

int work(const StressOptions& options, const StressPlan& plan, const GlobalOptions& global) {
  const StressAxis axis = chosen_axes(plan, {options.worker_axis}).front();
  work_on_axis(axis, plan, global, options.worker_folder, options.keep_pictures, !options.no_reuse);
  return kExitFine;
}

StressResults measure(const StressOptions& options, const StressPlan& plan, const GlobalOptions& global,
                      const std::filesystem::path& folder, VerbCache& cache) {
  StressResults results;
  results.plan = plan;
  results.version = kVersion;
  results.commit = kCommit;
  const StressKeys keys{plan.picture, stress_techniques(plan),
                        cache.makers(*open_realtime_renderer(global, find_home())),
                        find_exact_program().has_value()};
  results.device = keys.makers.realtime;
  if (!keys.has_oracle)
    print_warning("umbrameter-exact is not beside this program: no truth is held against exact arithmetic");
  results.rows = {std::string(kTruthRow)};
  for (const TechniqueRun& run : keys.techniques) results.rows.push_back(run.label);
  ProgressBar progress;
  for (const StressAxis& axis : plan.axes) {
    const std::vector<StressCell> cells =
        watch_axis(axis, plan, keys, cache.answers(), worker_arguments(options, global, plan, axis, folder),
                   folder, progress);
    results.cells.insert(results.cells.end(), cells.begin(), cells.end());
  }
  return results;
}

void write_results(const StressResults& results, const std::filesystem::path& out) {
  write_file_atomically(out / "stress.json", stress_json(results));
  write_file_atomically(out / "stress.md", stress_markdown(results));
  write_report(out, out / "report.html");
  print_note(fmt::format("wrote {}", (out / "report.html").string()));
}

int stress(const StressOptions& options, const GlobalOptions& global) {
  const StressPlan plan = plan_of(options);
  if (!options.worker_axis.empty()) return work(options, plan, global);
  if (options.markdown && global.json) fail_input("--markdown and --json both want the standard output");
  require_store(options.no_reuse, global);
  if (options.keep_pictures && global.out.empty())
    fail_input("--pictures needs --out", {}, "it names the folder they go to");
  const Staging staging(std::filesystem::temp_directory_path());
  const std::filesystem::path folder =
      options.keep_pictures ? std::filesystem::absolute(global.out) : staging.folder();
  // Pictures are of cells that are walked.
  VerbCache cache = open_cache(global, global.out, !options.no_reuse && !options.keep_pictures);
  const StressResults results = measure(options, plan, global, folder, cache);
  print_reuse(cache);
  if (!global.out.empty()) {
    create_folder(global.out);
    write_results(results, global.out);
  }
  print_answer(global.json        ? stress_json(results)
               : options.markdown ? stress_markdown(results)
                                  : stress_text(results));
  if (!results.measured_anything()) {
    print_error("nothing was measured: no technique has an error at any value");
    return kExitGateFailed;
  }
  if (results.passes()) return kExitFine;
  print_error(fmt::format("{} cells are against the rules", results.violations().size()));
  return kExitGateFailed;
}

}  // namespace

void add_stress(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<StressOptions>();
  CLI::App* verb = app.add_subcommand(
      "stress", "walk scenes and parameters to where the truth and the techniques break (docs/stability.md)");
  verb->fallthrough();
  verb->add_option("suite", options->suite, "suite file; without one every axis is walked");
  verb->add_option("--technique", options->techniques, "ID or folder; repeatable; default: all")
      ->allow_extra_args(false);
  verb->add_option("--axis", options->axes, "only this axis; repeatable")->allow_extra_args(false);
  verb->add_option("--width", options->width_px, "of pictures, px")->check(CLI::Range(1, 16384));
  verb->add_option("--height", options->height_px, "of pictures, px")->check(CLI::Range(1, 16384));
  verb->add_option("--spp", options->samples_per_pixel, "samples per pixel of the truth")
      ->check(CLI::Range(8, 1 << 20));
  verb->add_option("--seed", options->seed, "seed of all sampling");
  verb->add_option("--timeout", options->timeout_s, "seconds after which a picture hangs")
      ->check(CLI::Range(1, 86400));
  verb->add_flag("--no-reuse", options->no_reuse, "walk again what the store in --out knows");
  verb->add_flag("--markdown", options->markdown, "print the tables of docs/stability.md");
  verb->add_flag("--pictures", options->keep_pictures,
                 "keep scenes, and pictures of what is not ok, in --out");
  verb->add_option("--worker-axis", options->worker_axis)->group("");
  verb->add_option("--worker-folder", options->worker_folder)->group("");
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return stress(*options, line.global); }; });
}

}  // namespace umbrameter

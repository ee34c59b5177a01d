// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/selftest.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/reuse.h"
#include "cli/staging.h"
#include "core/files.h"
#include "reference/reference.h"
#include "report/selftest_output.h"

#include <thread>

namespace umbrameter {
namespace {

constexpr int kSamplesPerPixel = 256;
/// A size and samples that limits and rules were not made with.
constexpr SelftestRound kHeldOut{400, 225, 7};

struct SelftestOptions {
  std::vector<std::string> scenes;
  SelftestRound round;
  std::string only;
  size_t trials = 0;
  bool all = false;
  SelftestParts asked = {false, false, false, false};
  bool with_assets = false, no_reuse = false;
};

/// Scenes that need no assets; with `with_assets` also those whose assets are there.
std::vector<std::string> library_scenes(const SceneSearch& search, bool with_assets) {
  std::vector<std::string> names;
  for (const SceneEntry& entry : list_scenes(search)) {
    if (with_assets && !entry.missing_assets.empty())
      print_note(entry.name + " is left out: its models are not there (set UMBRAMETER_ASSETS)");
    else if (with_assets || !entry.needs_assets)
      names.push_back(entry.name);
  }
  return names;
}

/// Any other number than the one asked for.
int other_threads(int threads) {
  const int asked = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  return asked > 1 ? 1 : 2;
}

SelftestParts parts_of(const SelftestParts& asked) {
  const bool any = asked.benign || asked.faults || asked.causes || asked.hardening;
  return any ? asked : SelftestParts{};
}

int selftest(const SelftestOptions& options, const GlobalOptions& global) {
  require_store(options.no_reuse, global);
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  std::vector<SceneJob> jobs;
  for (const std::string& name :
       options.scenes.empty() ? library_scenes(search, options.with_assets || options.all) : options.scenes) {
    for (SceneJob& job : load_scene_jobs(name, search)) jobs.push_back(std::move(job));
  }
  const Staging staging(std::filesystem::temp_directory_path());
  const auto realtime = open_realtime_renderer(global, home);
  VerbCache cache = open_cache(global, global.out, !options.no_reuse);
  PictureQuality truth;
  truth.samples_per_pixel = kSamplesPerPixel;
  Renderer& reference = cache.reference(truth);
  const auto other = make_reference_renderer({kSamplesPerPixel, {}, other_threads(global.threads)});
  SelftestSettings settings;
  settings.rounds = {options.round};
  if (options.all) settings.rounds.push_back(kHeldOut);
  settings.parts = parts_of(options.asked);
  settings.only = options.only;
  settings.fewest_benign = options.trials;
  settings.techniques_folder = home.techniques;
  settings.shaders_folder = home.shaders;
  settings.scratch_folder = staging.folder();
  settings.pictures_folder = global.out;
  settings.describe_run = [&home](const TechniqueChoice& choice) {
    return technique_with(choice.technique, choice.parameters, home);
  };
  settings.answers = &cache.answers();
  settings.makers = cache.makers(*realtime);
  settings.samples_per_pixel = kSamplesPerPixel;
  settings.techniques_hash = hash_folder(home.techniques);
  if (!global.out.empty()) create_folder(global.out);
  ProgressBar progress;
  const SelftestResults results = run_selftest(jobs, settings, {reference, *other, *realtime}, progress);
  print_reuse(cache);
  print_answer(global.json ? selftest_json(results) + "\n" : selftest_markdown(results));
  if (results.passes()) return kExitFine;
  print_error("the selftest misses a target");
  return kExitGateFailed;
}

}  // namespace

void add_selftest(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<SelftestOptions>();
  CLI::App* verb = app.add_subcommand(
      "selftest", "test the tester: known faults must be found and named, benign changes must pass");
  verb->fallthrough();
  verb->add_option("--scene", options->scenes, "only this scene and its faults; repeatable")
      ->allow_extra_args(false);
  verb->add_option("--only", options->only, "only trials whose name contains this");
  verb->add_option("--trials", options->trials,
                   "of changes that are no faults, at least: more rounds of other sizes and seeds")
      ->check(CLI::Range(0, 100000));
  verb->add_flag("--faults", options->asked.faults, "only the faults, and what else is asked for by name");
  verb->add_flag("--benign", options->asked.benign,
                 "only the changes that are no faults, and the masks, and what else is asked for by name");
  verb->add_flag("--causes", options->asked.causes,
                 "what mends each fault: it must be what was put in (docs/causes.md)");
  verb->add_flag("--hardening", options->asked.hardening, "of which scenes contact hardening can be told");
  verb->add_flag("--all", options->all,
                 "the whole: scenes of real models, and everything once more at a held-out size and seed");
  verb->add_option("--seed", options->round.seed, "of the samples");
  verb->add_flag("--no-reuse", options->no_reuse, "try again what the store in --out knows");
  verb->add_flag("--assets-too", options->with_assets, "also the scenes of real models");
  verb->add_option("--width", options->round.width_px,
                   "of the pictures in px; what is given as right was seen at 320 x 180")
      ->check(CLI::Range(64, 4096));
  verb->add_option("--height", options->round.height_px, "of the pictures in px")
      ->check(CLI::Range(64, 4096));
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return selftest(*options, line.global); }; });
}

}  // namespace umbrameter

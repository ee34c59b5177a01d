// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/home.h"
#include "cli/scene_options.h"
#include "cli/view_verb.h"
#include "core/error.h"
#include "core/files.h"
#ifdef UMBRAMETER_HAS_VIEW
#include "scenes/choose_light.h"
#include "view/view.h"
#endif

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

struct ViewOptions {
  std::string scene;
  std::string technique = "pcss";
  std::vector<std::string> assignments;
  std::string preset;
  std::string script;
  int64_t width_px = 960, height_px = 540;
  int64_t bench_frames = 0;
};

#ifdef UMBRAMETER_HAS_VIEW

/// Turns the camera for as many pictures, then waits for the truth.
std::string bench_script(int64_t frames) {
  return fmt::format("wait full\norbit {}\nwait full\nwait truth {}\nwait judged\nclose\n", frames,
                     kWantedSe);
}

std::vector<ScriptStep> script_of(const ViewOptions& options) {
  if (!options.script.empty()) return parse_script(read_file(options.script), options.script);
  return options.bench_frames > 0 ? parse_script(bench_script(options.bench_frames), "--bench")
                                  : std::vector<ScriptStep>();
}

std::vector<SceneChoice> choices(const SceneSearch& search) {
  std::vector<SceneChoice> all;
  for (const SceneEntry& entry : list_scenes(search))
    all.push_back({entry.name, entry.title, fmt::format("{}", fmt::join(entry.missing_assets, ", "))});
  return all;
}

ViewSetup setup_of(const ViewOptions& options, const GlobalOptions& global) {
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  const std::filesystem::path file = resolve_scene(options.scene, search);
  std::vector<std::string> assignments = options.assignments;
  if (!options.preset.empty()) assignments.push_back("preset=" + options.preset);
  const TechniqueRun run = choose_technique(options.technique, assignments, home);
  ViewSetup setup;
  setup.script = script_of(options);
  setup.techniques = list_techniques(home.techniques, home.shaders);
  std::erase_if(setup.techniques, [&](const Technique& technique) { return technique.id == run.id; });
  setup.techniques.push_back(
      find_technique(run.technique, home.techniques, home.shaders));  // maybe a folder's
  std::ranges::sort(setup.techniques, {}, &Technique::id);
  setup.technique = run.id;
  setup.parameters = run.parameters;
  setup.scene = load_scene(file, search);
  setup.scenes = choices(search);
  setup.at = search.at;
  SceneSearch others = search;
  others.at.reset();
  setup.load_scene = [others](const std::string& name) {
    return load_scene(resolve_scene(name, others), others);
  };
  if (!global.light.empty()) setup.scene.active_light = find_light(setup.scene.lights, global.light);
  setup.scene_name = timed_name(scene_name(file, search), search.at);
  setup.open_renderer = [global, home] { return open_gl_renderer(global, home); };
  setup.techniques_folder = home.techniques;
  setup.shaders_folder = home.shaders;
  setup.threads = global.threads;
  setup.width_px = static_cast<int>(options.width_px);
  setup.height_px = static_cast<int>(options.height_px);
  setup.folder = global.out;
  return setup;
}

nlohmann::ordered_json to_json(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

std::string number_text(const std::optional<double>& value, const char* unit) {
  return value ? fmt::format("{:.3g}{}", *value, unit) : "not measured";
}

void print_report(const ViewReport& report, const ViewSetup& setup, bool json) {
  if (json) {
    print_json({{"scene", setup.scene_name},
                {"width_px", setup.width_px},
                {"height_px", setup.height_px},
                {"device", report.device},
                {"moving_frames", report.moving_frames},
                {"moving_fps", to_json(report.moving_fps)},
                {"full_frame_s", to_json(report.full_frame_s)},
                {"truth_s", to_json(report.truth_s)},
                {"truth_se_rms", to_json(report.truth_se_rms)},
                {"truth_se_max", to_json(report.truth_se_max)},
                {"rmse", to_json(report.rmse)},
                {"problem", report.problem},
                {"switches", report.switches},
                {"memory_first_mib", report.memory_first_mib},
                {"memory_last_mib", report.memory_last_mib}});
    return;
  }
  print_answer(fmt::format(
      "{} at {} x {} px on {}: {} while moving ({} pictures), {} a full picture, truth to se {:g} in {}\n",
      setup.scene_name, setup.width_px, setup.height_px, report.device,
      number_text(report.moving_fps, " pictures a second"), report.moving_frames,
      number_text(report.full_frame_s, " s"), kWantedSe, number_text(report.truth_s, " s")));
}

int view(const ViewOptions& options, const GlobalOptions& global) {
  const ViewSetup setup = setup_of(options, global);
  for (const std::string& warning : setup.scene.warnings) print_warning(warning);
  const ViewReport report = run_view(setup);
  if (!setup.script.empty() || global.json) print_report(report, setup, global.json);
  return kExitFine;
}

#else

int view(const ViewOptions&, const GlobalOptions&) {
  fail_environment("this umbrameter was built without its window",
                   "install libglfw3-dev and libimgui-dev, and build again");
}

#endif

}  // namespace

void add_view(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* verb = app.add_subcommand("view", "fly through a scene in a window, technique beside truth");
  verb->fallthrough();
  verb->add_option("scene", options->scene, "library name or scene file")->required();
  verb->add_option("--technique", options->technique, "ID[:name=value,...]; ID may be a folder")
      ->capture_default_str();
  verb->add_option("--set", options->assignments, "name=value; repeatable")->allow_extra_args(false);
  verb->add_option("--preset", options->preset, "a preset of the technique, or a file that 'tune' wrote");
  verb->add_option("--light", line.global.light, "name or number of the light that is shown first");
  add_time_options(*verb, line.global);
  verb->add_option("--width", options->width_px, "of the picture at the start, px")
      ->check(CLI::Range(int64_t{64}, int64_t{8192}))
      ->capture_default_str();
  verb->add_option("--height", options->height_px, "of the picture at the start, px")
      ->check(CLI::Range(int64_t{64}, int64_t{8192}))
      ->capture_default_str();
  CLI::Option* script = verb->add_option("--script", options->script,
                                         "a file of keys and mouse moves (docs/view.md), then close");
  verb->add_option("--bench", options->bench_frames,
                   "turn the camera for this many pictures, print times, close")
      ->check(CLI::Range(int64_t{1}, int64_t{100000}))
      ->excludes(script);
  verb->callback([options, &line] { line.verb = [options, &line] { return view(*options, line.global); }; });
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/exact_program.h"
#include "cli/home.h"
#include "core/error.h"
#include "core/version.h"
#include "realtime/realtime.h"
#include "reference/reference.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// A part that this machine lacks: what is lost and what would bring it.
struct Missing {
  std::string loss;
  std::string remedy;
};

std::vector<Missing> find_missing(const std::vector<SceneEntry>& scenes,
                                  const std::vector<GlDevice>& devices) {
  std::vector<Missing> missing;
  const auto without =
      std::ranges::count_if(scenes, [](const SceneEntry& entry) { return !entry.missing_assets.empty(); });
  if (without > 0) {
    missing.push_back({fmt::format("{} of {} scenes lack their models", without, scenes.size()),
                       "put the OBJ files that 'scene list --json' names into a folder and give --assets or "
                       "UMBRAMETER_ASSETS"});
  }
  const auto is_usable_gpu = [](const GlDevice& d) { return d.problem.empty() && d.is_hardware; };
  if (std::ranges::none_of(devices, is_usable_gpu)) {
    missing.push_back({"no GPU: times are those of a software rasteriser",
                       "install the GPU's EGL driver; pictures and errors are valid without"});
  }
  if (!find_exact_program()) {
    missing.push_back({"umbrameter-exact is not beside this program: no 'reference --exact-check'",
                       "install the package umbrameter-exact, or build the target of that name"});
  }
  return missing;
}

std::string verdict_text(const std::vector<Missing>& missing) {
  if (missing.empty()) return "verdict        all is well: both renderers work and nothing is missing\n";
  std::string text = "verdict        both renderers work; without these parts:\n";
  for (const auto& [loss, remedy] : missing)
    text += fmt::format("  - {}\n    to have it: {}\n", loss, remedy);
  return text;
}

/// Both renderers, run once on the first built-in scene.
struct Trial {
  std::string scene;
  std::string reference_device;
  std::string realtime_device;
  std::string timer;
};

Trial try_renderers(const GlobalOptions& global, const Home& home, const SceneSearch& search) {
  Trial trial;
  const std::vector<SceneEntry> scenes = list_scenes(search);
  const std::vector<TechniqueRun> techniques = all_techniques(home);
  if (scenes.empty() || techniques.empty()) fail_environment("the library has no scenes or no techniques");
  const SceneJob job = load_scene_job(scenes.front().name, search);
  trial.scene = job.name;
  SilentProgress progress;
  RenderRequest request{.width_px = 64, .height_px = 36, .technique = {}, .parameters = {}};
  trial.reference_device =
      make_reference_renderer({.samples_per_pixel = kReplicates, .target_se = {}, .threads = global.threads})
          ->render(job.scene, request, progress)
          .device;
  const LightType light = job.scene.light().type;
  const auto usable = std::find_if(techniques.begin(), techniques.end(), [&](const TechniqueRun& run) {
    return std::find(run.lights.begin(), run.lights.end(), light) != run.lights.end();
  });
  if (usable == techniques.end())
    fail_environment(fmt::format("no technique supports the light of '{}'", job.name));
  request.technique = usable->technique;
  request.parameters = usable->parameters;
  const auto renderer = open_realtime_renderer(global, home);
  const PreparedRun run = renderer->prepare(job.scene, request, progress);
  trial.realtime_device = run.frame.device;
  trial.timer = run.timer;
  return trial;
}

OrderedJson device_json(const GlDevice& device) {
  return {{"index", device.index},
          {"renderer", device.renderer},
          {"version", device.version},
          {"is_hardware", device.is_hardware},
          {"problem", device.problem}};
}

std::string device_text(const GlDevice& device) {
  const std::string state =
      device.problem.empty() ? (device.is_hardware ? "hardware" : "software") : device.problem;
  return fmt::format("GL device {}    {}, {}: {}\n", device.index, device.renderer, device.version, state);
}

int doctor(const GlobalOptions& global) {
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  const std::vector<SceneEntry> scenes = list_scenes(search);
  const auto missing = std::count_if(scenes.begin(), scenes.end(),
                                     [](const SceneEntry& entry) { return !entry.missing_assets.empty(); });
  const std::string assets = global.assets.empty() ? "none (--assets or UMBRAMETER_ASSETS)" : global.assets;
  std::string text = fmt::format("umbrameter     {} ({})\nEmbree         {}\nOpenImageIO    {}\n", kVersion,
                                 kCommit, UMBRAMETER_EMBREE_VERSION, UMBRAMETER_OPENIMAGEIO_VERSION);
  text += fmt::format("library        {}: {} scenes, {} of them without their assets\nassets         {}\n",
                      home.library.string(), scenes.size(), missing, assets);
  OrderedJson devices = OrderedJson::array();
  const std::vector<GlDevice> all_devices = list_gl_devices();
  for (const GlDevice& device : all_devices) {
    devices.push_back(device_json(device));
    text += device_text(device);
  }
  if (!global.json) print_answer(text);
  const Trial trial = try_renderers(global, home, search);
  const std::vector<Missing> missing_parts = find_missing(scenes, all_devices);
  if (!global.json) {
    print_answer(fmt::format("trial          '{}' by {} and {}, timed by {}\n", trial.scene,
                             trial.reference_device, trial.realtime_device, trial.timer));
    print_answer(verdict_text(missing_parts));
    return kExitFine;
  }
  OrderedJson lacking = OrderedJson::array();
  for (const auto& [loss, remedy] : missing_parts) lacking.push_back({{"loss", loss}, {"remedy", remedy}});
  print_json({{"version", kVersion},
              {"commit", kCommit},
              {"embree", UMBRAMETER_EMBREE_VERSION},
              {"openimageio", UMBRAMETER_OPENIMAGEIO_VERSION},
              {"library", home.library.string()},
              {"scenes", scenes.size()},
              {"scenes_without_assets", missing},
              {"assets", global.assets},
              {"gl_devices", devices},
              {"reference_device", trial.reference_device},
              {"realtime_device", trial.realtime_device},
              {"timer", trial.timer},
              {"missing", lacking}});
  return kExitFine;
}

}  // namespace

void add_doctor(CLI::App& app, CommandLine& line) {
  CLI::App* verb = app.add_subcommand("doctor", "devices, versions, folders, and a trial of both renderers");
  verb->fallthrough();
  verb->callback([&line] { line.verb = [&line] { return doctor(line.global); }; });
}

}  // namespace umbrameter

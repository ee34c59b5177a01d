// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/quality.h"
#include "cli/scene_export.h"
#include "cli/scene_import.h"
#include "cli/scene_options.h"
#include "cli/scene_show.h"
#include "scenes/check_scene.h"
#include "scenes/instances.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

int print_scenes(const GlobalOptions& global) {
  OrderedJson scenes = OrderedJson::array();
  std::vector<std::vector<std::string>> rows;
  for (const SceneEntry& entry : list_scenes(scene_search(global, find_home()))) {
    scenes.push_back({{"name", entry.name},
                      {"title", entry.title},
                      {"file", entry.file.string()},
                      {"needs_assets", entry.needs_assets},
                      {"missing_assets", entry.missing_assets}});
    rows.push_back({entry.name, entry.missing_assets.empty() ? "" : "assets missing", entry.title});
  }
  if (global.json) {
    print_json({{"scenes", scenes}});
  } else {
    print_answer(format_table({"name", "", "title"}, rows));
  }
  return kExitFine;
}

/// "disk light 'lamp'" or "2 lights: disk 'lamp', sun 'sun'".
std::string describe(const std::vector<Light>& lights) {
  if (lights.size() == 1)
    return fmt::format("{} light '{}'", to_text(lights.front().type), lights.front().name);
  std::string text;
  for (const Light& light : lights)
    text += fmt::format("{}{} '{}'", text.empty() ? "" : ", ", to_text(light.type), light.name);
  return fmt::format("{} lights: {}", lights.size(), text);
}

int check_scenes(const std::vector<std::string>& names, const GlobalOptions& global) {
  const SceneSearch search = scene_search(global, find_home());
  OrderedJson scenes = OrderedJson::array();
  std::string text;
  for (const std::string& name : names) {
    const std::filesystem::path file = resolve_scene(name, search);
    const Scene scene = load_scene(file, search);
    const std::string own_name = timed_name(scene_name(file, search), search.at);
    const glm::dvec3 size_world = scene.bounds_world.max - scene.bounds_world.min;
    text += fmt::format("{}: fine; {} triangles, {:.4g} x {:.4g} x {:.4g}, {}, hash {}\n", own_name,
                        count_shown_triangles(scene), size_world.x, size_world.y, size_world.z,
                        describe(scene.lights), scene.hash);
    std::vector<std::string> warnings = scene.warnings;
    for (std::string& found : check_scene(scene)) warnings.push_back(std::move(found));
    for (const std::string& warning : warnings) text += fmt::format("{}: warning: {}\n", own_name, warning);
    OrderedJson lights = OrderedJson::array();
    for (const Light& light : scene.lights)
      lights.push_back({{"name", light.name}, {"type", to_text(light.type)}});
    scenes.push_back({{"name", own_name},
                      {"title", scene.title},
                      {"hash", scene.hash},
                      {"triangles", count_shown_triangles(scene)},
                      {"lights", lights},
                      {"warnings", warnings}});
  }
  if (global.json) {
    print_json({{"scenes", scenes}});
  } else {
    print_answer(text);
  }
  return kExitFine;
}

std::vector<SceneJob> load_all(const std::vector<std::string>& names, const SceneSearch& search) {
  std::vector<SceneJob> jobs;
  for (const std::string& name : names) {
    for (SceneJob& job : load_scene_jobs(name, search)) jobs.push_back(std::move(job));
  }
  return jobs;
}

/// What `validate` with the same options would render, and what it would leave out.
int plan(const std::vector<std::string>& names, const QualityOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_quality(options);
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  const std::vector<TechniqueRun> techniques = all_techniques(home);
  OrderedJson scenes = OrderedJson::array();
  std::string text;
  for (const SceneJob& job : load_all(names, search)) {
    const int64_t pixels = int64_t{quality.picture.width_px} * quality.picture.height_px;
    const int64_t most_shadow_rays = pixels * quality.picture.samples_per_pixel;
    OrderedJson runs = OrderedJson::array();
    OrderedJson skips = OrderedJson::array();
    text += fmt::format(
        "{}: {} x {} px, {} triangles, {} light '{}'; reference at most {:.1f} million shadow rays\n",
        job.name, quality.picture.width_px, quality.picture.height_px, count_shown_triangles(job.scene),
        to_text(job.scene.light().type), job.scene.light().name,
        static_cast<double>(most_shadow_rays) * 1e-6);
    for (const TechniqueRun& run : techniques) {
      const auto reason = skip_reason(run, job.scene);
      text += fmt::format("  {:<6}{}{}\n", reason ? "skip" : "run", run.label, reason ? ": " + *reason : "");
      if (reason) skips.push_back({{"technique", run.label}, {"reason", *reason}});
      if (!reason) runs.push_back(run.label);
    }
    scenes.push_back({{"name", job.name},
                      {"hash", job.scene.hash},
                      {"width_px", quality.picture.width_px},
                      {"height_px", quality.picture.height_px},
                      {"most_shadow_rays", most_shadow_rays},
                      {"runs", runs},
                      {"skips", skips}});
  }
  if (global.json) {
    print_json({{"scenes", scenes}});
  } else {
    print_answer(text);
  }
  return kExitFine;
}

}  // namespace

void add_scene(CLI::App& app, CommandLine& line) {
  auto names = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand(
      "scene", "list the library, check scene files, or say what validate would do with them");
  verb->fallthrough();
  verb->require_subcommand(1);
  CLI::App* list_verb = verb->add_subcommand("list", "the scenes of the library");
  list_verb->fallthrough();
  list_verb->callback([&line] { line.verb = [&line] { return print_scenes(line.global); }; });
  CLI::App* check_verb = verb->add_subcommand("check", "load scenes and say what is in them");
  check_verb->fallthrough();
  check_verb->add_option("scene", *names, "library names or scene files")->required();
  add_time_options(*check_verb, line.global);
  check_verb->callback(
      [names, &line] { line.verb = [names, &line] { return check_scenes(*names, line.global); }; });
  auto quality = std::make_shared<QualityOptions>();
  CLI::App* plan_verb =
      verb->add_subcommand("plan", "what validate would render, and what it would skip and why");
  plan_verb->fallthrough();
  plan_verb->add_option("scene", *names, "library names or scene files")->required();
  add_scene_options(*plan_verb, line.global);
  add_quality_options(*plan_verb, *quality);
  plan_verb->callback([names, quality, &line] {
    line.verb = [names, quality, &line] { return plan(*names, *quality, line.global); };
  });
  auto scene = std::make_shared<std::string>();
  CLI::App* import_verb = verb->add_subcommand(
      "import", "a scene file to --out (default scene.toml) that refers to a file of another program");
  import_verb->fallthrough();
  import_verb->add_option("file", *scene, ".gltf, .glb, .fbx, .xml (Mitsuba) or .pbrt")->required();
  add_time_options(*import_verb, line.global);
  import_verb->callback(
      [scene, &line] { line.verb = [scene, &line] { return import_scene(*scene, line.global); }; });
  CLI::App* show_verb =
      verb->add_subcommand("show", "a lit picture with shadows of a scene to --out (default scene.png)");
  show_verb->fallthrough();
  show_verb->add_option("scene", *scene, "library name or scene file")->required();
  add_scene_options(*show_verb, line.global);
  show_verb->callback(
      [scene, &line] { line.verb = [scene, &line] { return show_scene(*scene, line.global); }; });
  CLI::App* export_verb = verb->add_subcommand(
      "export", "mesh, camera and light for another engine, into --out (docs/your-engine.md)");
  export_verb->fallthrough();
  export_verb->add_option("scene", *scene, "library name or scene file")->required();
  add_one_view_options(*export_verb, line.global);
  add_quality_options(*export_verb, *quality);
  export_verb->callback([scene, quality, &line] {
    line.verb = [scene, quality, &line] { return export_scene(*scene, *quality, line.global); };
  });
}

}  // namespace umbrameter

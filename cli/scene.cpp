#include "scenes/scene.h"

#include "cli/console.h"
#include "cli/home.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

int list(const GlobalOptions& global) {
  Json scenes = Json::array();
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

int check(const std::vector<std::string>& names, const GlobalOptions& global) {
  const SceneSearch search = scene_search(global, find_home());
  Json scenes = Json::array();
  std::string text;
  for (const std::string& name : names) {
    const SceneJob job = load_scene_job(name, search);
    const Scene& scene = job.scene;
    const glm::dvec3 size_world = scene.bounds_world.max - scene.bounds_world.min;
    text += fmt::format("{}: fine; {} triangles, {:.4g} x {:.4g} x {:.4g}, {} light '{}', hash {}\n",
                        job.name, scene.triangles.size(), size_world.x, size_world.y, size_world.z,
                        to_text(scene.light().type), scene.light().name, scene.hash);
    for (const std::string& warning : scene.warnings)
      text += fmt::format("{}: warning: {}\n", job.name, warning);
    scenes.push_back({{"name", job.name},
                      {"title", scene.title},
                      {"hash", scene.hash},
                      {"triangles", scene.triangles.size()},
                      {"light", {{"name", scene.light().name}, {"type", to_text(scene.light().type)}}},
                      {"warnings", scene.warnings}});
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
  CLI::App* verb = app.add_subcommand("scene", "list the library or check scene files");
  verb->fallthrough();
  verb->require_subcommand(1);
  CLI::App* list_verb = verb->add_subcommand("list", "the scenes of the library");
  list_verb->fallthrough();
  list_verb->callback([&line] { line.verb = [&line] { return list(line.global); }; });
  CLI::App* check_verb = verb->add_subcommand("check", "load scenes and say what is in them");
  check_verb->fallthrough();
  check_verb->add_option("scene", *names, "library names or scene files")->required();
  check_verb->callback([names, &line] { line.verb = [names, &line] { return check(*names, line.global); }; });
}

}  // namespace umbrameter

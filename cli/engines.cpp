// SPDX-License-Identifier: Apache-2.0
#include "engines/engines.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/staging.h"
#include "cli/techniques_verbs.h"
#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kWidth_px = 192, kHeight_px = 108;

OrderedJson lights_json(const Engine& engine) {
  OrderedJson lights = OrderedJson::object();
  for (const auto& [type, text] : engine.lights) lights[std::string(to_text(type))] = text;
  return lights;
}

std::string light_names(const Engine& engine) {
  std::string names;
  for (const auto& [type, text] : engine.lights)
    names += fmt::format("{}{}", names.empty() ? "" : " ", to_text(type));
  return names;
}

int print_engines(const GlobalOptions& global) {
  OrderedJson engines = OrderedJson::array();
  std::vector<std::vector<std::string>> rows;
  for (const Engine& engine : list_engines(find_home().engines)) {
    const bool is_installed = engine.missing.empty();
    engines.push_back({{"id", engine.id},
                       {"title", engine.title},
                       {"form", to_text(engine.form)},
                       {"quantity", to_text(engine.quantity)},
                       {"lights", lights_json(engine)},
                       {"installed", is_installed},
                       {"hash", engine.hash}});
    rows.push_back({engine.id, is_installed ? "installed" : "not installed",
                    std::string(to_text(engine.quantity)), light_names(engine), engine.title});
  }
  if (global.json) {
    print_json({{"engines", engines}});
  } else {
    print_answer(format_table({"id", "", "quantity", "lights", "title"}, rows));
  }
  return kExitFine;
}

std::string parity_of(const Frame& frame) {
  const auto found = frame.image.metadata.find("engine_parity");
  return found == frame.image.metadata.end() ? "" : found->second;
}

/// A small picture of one built-in scene for each light type that the engine supports.
OrderedJson try_lights(const Engine& engine, const std::string& request_text, const GlobalOptions& global,
                       const Home& home) {
  const auto renderer = open_realtime_renderer(global, home);
  const TechniqueRun run = choose_technique(request_text, {}, home);
  SilentProgress progress;
  OrderedJson lights = OrderedJson::object();
  for (const auto& [type, job] : scenes_by_light(scene_search(global, home))) {
    if (!engine.supports(type)) continue;
    const RenderRequest request{.width_px = kWidth_px,
                                .height_px = kHeight_px,
                                .technique = run.technique,
                                .parameters = run.parameters};
    const Frame frame = renderer->render(job.scene, request, progress);
    lights[std::string(to_text(type))] = {{"scene", job.name},
                                          {"becomes", engine.lights.at(type)},
                                          {"surfaces_agree", parity_of(frame)},
                                          {"warnings", frame.warnings}};
  }
  return lights;
}

/// Loads the manifest, starts the engine, and lets it draw once for every light type that it supports.
int check_engine(const std::string& id_or_path, const GlobalOptions& global) {
  const Home home = find_home();
  const std::filesystem::path folder = find_engine_folder(id_or_path, home.engines);
  if (folder.empty())
    fail_input(fmt::format("there is no engine '{}'", id_or_path), {},
               "'engines list' names those that there are");
  const Engine engine = load_engine(folder, home.engines);
  require_installed(engine);
  EngineCheck found;
  {
    const Staging staging(std::filesystem::temp_directory_path() / "umbrameter-check");
    found = check_engine(engine, staging.folder());
  }
  const bool has_finished_pictures = engine.form == EngineForm::pictures;
  const OrderedJson lights =
      has_finished_pictures ? OrderedJson::object() : try_lights(engine, id_or_path, global, home);
  if (global.json) {
    print_json({{"id", engine.id},
                {"version", found.version},
                {"device", found.device},
                {"hash", engine.hash},
                {"lights", lights}});
    return kExitFine;
  }
  std::string text = fmt::format("{}: fine; {}{}{}\n", engine.id, found.version,
                                 found.device.empty() ? "" : ", ", found.device);
  for (const auto& [type, light] : lights.items()) {
    text +=
        fmt::format("{}: {}; on '{}' the surfaces agree in {}\n", type, light["becomes"].get<std::string>(),
                    light["scene"].get<std::string>(), light["surfaces_agree"].get<std::string>());
    for (const OrderedJson& warning : light["warnings"])
      print_warning(fmt::format("{}: {}", type, warning.get<std::string>()));
  }
  print_answer(text);
  return kExitFine;
}

}  // namespace

void add_engines(CLI::App& app, CommandLine& line) {
  auto name = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("engines", "list, show or check other renderers (docs/engines.md)");
  verb->fallthrough();
  verb->require_subcommand(0, 1);
  verb->callback([&line, verb] {
    if (verb->get_subcommands().empty()) line.verb = [&line] { return print_engines(line.global); };
  });
  CLI::App* list_verb = verb->add_subcommand("list", "the engines that ship, and whether they are installed");
  list_verb->fallthrough();
  list_verb->callback([&line] { line.verb = [&line] { return print_engines(line.global); }; });
  CLI::App* show_verb = verb->add_subcommand("show", "one engine with its parameters and presets");
  show_verb->fallthrough();
  show_verb->add_option("engine", *name, "id or folder")->required();
  show_verb->callback(
      [name, &line] { line.verb = [name, &line] { return show_technique(*name, line.global); }; });
  CLI::App* check_verb =
      verb->add_subcommand("check", "load an engine, start it, and draw a small picture with each light");
  check_verb->fallthrough();
  check_verb->add_option("engine", *name, "id or folder")->required();
  check_verb->callback(
      [name, &line] { line.verb = [name, &line] { return check_engine(*name, line.global); }; });
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/home.h"
#include "cli/techniques_verbs.h"
#include "core/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<std::string> light_names(const std::vector<LightType>& lights) {
  std::vector<std::string> names;
  for (const LightType light : lights) names.emplace_back(to_text(light));
  return names;
}

OrderedJson to_json(const Parameter& parameter) {
  OrderedJson json = {{"name", parameter.name}, {"type", to_text(parameter.type)}};
  std::visit([&](const auto& value) { json["default"] = value; }, parameter.default_value);
  if (parameter.type == ParameterType::integer || parameter.type == ParameterType::real) {
    json["min"] = parameter.min;
    json["max"] = parameter.max;
    json["step"] = parameter.step;
    json["scale"] = to_text(parameter.scale);
    json["relative_to"] = parameter.is_relative_to_scene ? "scene" : "nothing";
  }
  if (parameter.type == ParameterType::choice) json["choices"] = parameter.choices;
  json["unit"] = parameter.unit;
  if (!parameter.when.empty()) json["when"] = parameter.when;
  json["stage"] = to_text(parameter.stage);
  json["group"] = parameter.group;
  json["doc"] = parameter.doc;
  return json;
}

OrderedJson to_json(const Technique& technique) {
  OrderedJson parameters = OrderedJson::array();
  for (const Parameter& parameter : technique.parameters) parameters.push_back(to_json(parameter));
  OrderedJson presets = OrderedJson::object();
  for (const Preset& preset : technique.presets) presets[preset.name] = preset.doc;
  return {{"id", technique.id},
          {"title", technique.title},
          {"summary", technique.summary},
          {"family", technique.family},
          {"lights", light_names(technique.lights)},
          {"references", technique.references},
          {"known_failures", technique.known_failures},
          {"hash", technique.hash},
          {"parameters", parameters},
          {"presets", presets}};
}

int print_techniques(const GlobalOptions& global) {
  OrderedJson techniques = OrderedJson::array();
  std::vector<std::vector<std::string>> rows;
  for (const Technique& technique : list_techniques(find_home().techniques)) {
    techniques.push_back(to_json(technique));
    rows.push_back(
        {technique.id, fmt::format("{}", fmt::join(light_names(technique.lights), " ")), technique.title});
  }
  if (global.json) {
    print_json({{"techniques", techniques}});
  } else {
    print_answer(format_table({"id", "lights", "title"}, rows));
  }
  return kExitFine;
}

std::string range_text(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::boolean:
      return "true, false";
    case ParameterType::choice:
      return fmt::format("{}", fmt::join(parameter.choices, " "));
    case ParameterType::integer:
    case ParameterType::real:
      break;
  }
  return fmt::format("{} .. {}{} ({})", parameter.min, parameter.max,
                     parameter.is_relative_to_scene ? " diagonals" : "", to_text(parameter.scale));
}

std::string documentation_of(const Parameter& parameter) {
  if (parameter.when.empty()) return parameter.doc;
  return fmt::format("{} Acts only when {}.", parameter.doc, parameter.when);
}

std::string describe_technique(const Technique& technique) {
  std::string text = fmt::format("{}: {}\n{}\nlights: {}\n", technique.id, technique.title, technique.summary,
                                 fmt::join(light_names(technique.lights), " "));
  for (const std::string& reference : technique.references) text += "reference: " + reference + "\n";
  for (const std::string& failure : technique.known_failures) text += "fails: " + failure + "\n";
  std::vector<std::vector<std::string>> rows;
  for (const Parameter& parameter : technique.parameters) {
    rows.push_back({parameter.name, to_text(parameter.default_value), range_text(parameter), parameter.unit,
                    documentation_of(parameter)});
  }
  text += "\n" + format_table({"parameter", "default", "range", "unit", ""}, rows);
  for (const Preset& preset : technique.presets)
    text += fmt::format("preset {}: {}\n", preset.name, preset.doc);
  return text;
}

}  // namespace

int show_technique(const std::string& id, const GlobalOptions& global) {
  const Technique technique = find_run(id, find_home());
  if (global.json) {
    print_json(to_json(technique));
  } else {
    print_answer(describe_technique(technique));
  }
  return kExitFine;
}

std::map<LightType, SceneJob> scenes_by_light(const SceneSearch& search) {
  std::map<LightType, SceneJob> scenes;
  for (const SceneEntry& entry : list_scenes(search)) {
    if (entry.needs_assets) continue;
    for (SceneJob& job : load_scene_jobs(entry.name, search))
      scenes.try_emplace(job.scene.light().type, std::move(job));
  }
  return scenes;
}

namespace {

/// Loads the manifest, then compiles and runs the shaders once for every light type that it supports.
int check_technique(const std::string& path, const GlobalOptions& global) {
  const Home home = find_home();
  const TechniqueRun run = choose_technique(path, {}, home);
  const auto renderer = open_realtime_renderer(global, home);
  SilentProgress progress;
  std::vector<std::string> ran;
  for (const auto& [light, job] : scenes_by_light(scene_search(global, home))) {
    if (std::find(run.lights.begin(), run.lights.end(), light) == run.lights.end()) continue;
    RenderRequest request{
        .width_px = 64, .height_px = 36, .technique = run.technique, .parameters = run.parameters};
    const Frame frame = renderer->render(job.scene, request, progress);
    for (const std::string& warning : frame.warnings) print_warning(warning);
    require_finite(frame.image, "visibility");
    ran.emplace_back(to_text(light));
  }
  if (global.json) {
    print_json({{"id", run.id}, {"hash", run.hash}, {"ran_with_lights", ran}});
  } else {
    print_answer(fmt::format("{}: fine; ran with lights: {}\n", run.id,
                             ran.empty() ? "none" : fmt::format("{}", fmt::join(ran, " "))));
  }
  return kExitFine;
}

}  // namespace

void add_techniques(CLI::App& app, CommandLine& line) {
  auto name = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("techniques", "list, show or check techniques");
  verb->fallthrough();
  verb->require_subcommand(0, 1);
  verb->callback([&line, verb] {
    if (verb->get_subcommands().empty()) line.verb = [&line] { return print_techniques(line.global); };
  });
  CLI::App* list_verb = verb->add_subcommand("list", "the built-in techniques");
  list_verb->fallthrough();
  list_verb->callback([&line] { line.verb = [&line] { return print_techniques(line.global); }; });
  CLI::App* show_verb = verb->add_subcommand("show", "one technique with its parameters and presets");
  show_verb->fallthrough();
  show_verb->add_option("technique", *name, "id or folder")->required();
  show_verb->callback(
      [name, &line] { line.verb = [name, &line] { return show_technique(*name, line.global); }; });
  auto traits = std::make_shared<TraitsOptions>();
  CLI::App* traits_verb =
      verb->add_subcommand("traits", "precise, soft, anti-aliased, ...: paper E's table, measured");
  traits_verb->fallthrough();
  traits_verb->add_option("technique", traits->ids, "ids or folders; none = all");
  traits_verb
      ->add_option("--width", traits->picture.width_px,
                   "of the pictures in px; the verdicts' limits were made at 480 x 270")
      ->check(CLI::Range(16, 16384));
  traits_verb->add_option("--height", traits->picture.height_px, "of the pictures in px")
      ->check(CLI::Range(16, 16384));
  traits_verb->add_option("--spp", traits->picture.samples_per_pixel, "samples per pixel of the truth")
      ->check(CLI::Range(8, 1 << 20));
  traits_verb->add_flag("--no-reuse", traits->no_reuse, "measure again what the store in --out knows");
  traits_verb->callback(
      [traits, &line] { line.verb = [traits, &line] { return show_traits(*traits, line.global); }; });
  CLI::App* doc_verb =
      verb->add_subcommand("doc", "Markdown of all techniques and what a validation measured of them");
  doc_verb->fallthrough();
  doc_verb->add_option("results", *name, "results.json of a validation")->required();
  doc_verb->callback(
      [name, &line] { line.verb = [name, &line] { return write_technique_doc(*name, line.global); }; });
  CLI::App* check_verb = verb->add_subcommand("check", "load a technique, compile and run its shaders");
  check_verb->fallthrough();
  check_verb->add_option("technique", *name, "id or folder")->required();
  check_verb->callback(
      [name, &line] { line.verb = [name, &line] { return check_technique(*name, line.global); }; });
  CLI::App* glsl_verb = verb->add_subcommand("glsl", "the shaders of a technique as the driver gets them");
  glsl_verb->fallthrough();
  glsl_verb->add_option("technique", *name, "ID[:name=value,...]; ID may be a folder")->required();
  auto language = std::make_shared<std::string>("glsl");
  glsl_verb
      ->add_option("--language", *language, "glsl, spirv, hlsl, msl or essl (glslang-tools, spirv-cross)")
      ->capture_default_str();
  glsl_verb->callback([name, language, &line] {
    line.verb = [name, language, &line] { return show_shaders(*name, *language, line.global); };
  });
}

}  // namespace umbrameter

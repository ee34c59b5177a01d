// SPDX-License-Identifier: Apache-2.0
// `techniques traits` and `techniques doc`: what measurements say about the built-in techniques.

#include "cli/console.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/reuse.h"
#include "cli/technique_doc.h"
#include "cli/techniques_verbs.h"
#include "core/error.h"
#include "core/files.h"
#include "realtime/manifest/technique.h"
#include "results/json/results_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Numbers of the group "bias" at their minimum, choices at their first.
ParameterValues neutral_bias(const TechniqueRun& run, const Home& home) {
  ParameterValues values;
  for (const Parameter& parameter : find_technique(run.technique, home.techniques).parameters) {
    if (parameter.group != "bias") continue;
    if (parameter.type == ParameterType::real || parameter.type == ParameterType::integer)
      values[parameter.name] = value_of_number(parameter, parameter.min);
    if (parameter.type == ParameterType::boolean) values[parameter.name] = false;
    if (parameter.type == ParameterType::choice) values[parameter.name] = parameter.choices.front();
  }
  return values;
}

std::string cell_text(const TraitResult& result) {
  if (!result.value) return "n/a";
  return fmt::format("{} {:.2g}", symbol_of(*result.verdict), *result.value);
}

std::string claim_text(std::string_view id) {
  std::string text;
  for (const TraitVerdict verdict : paper_e_claim(id)) text += symbol_of(verdict);
  return text;
}

std::string traits_text(const std::vector<TechniqueTraits>& all) {
  std::vector<std::string> header{"technique"};
  for (size_t k = 0; k < kTraits; ++k) header.emplace_back(name_of(static_cast<Trait>(k)));
  header.emplace_back("paper E");
  std::vector<std::vector<std::string>> rows;
  for (const TechniqueTraits& traits : all) {
    std::vector<std::string> row{traits.id};
    for (const TraitResult& result : traits.results) row.push_back(cell_text(result));
    row.push_back(claim_text(traits.id));
    rows.push_back(std::move(row));
  }
  std::string text = format_table(header, rows);
  for (size_t k = 0; k < kTraits; ++k) {
    const auto trait = static_cast<Trait>(k);
    text += fmt::format("{}: {}\n", name_of(trait), measure_of(trait));
  }
  return text;
}

OrderedJson to_json(const std::vector<TechniqueTraits>& all) {
  OrderedJson techniques = OrderedJson::array();
  for (const TechniqueTraits& traits : all) {
    OrderedJson json = {{"id", traits.id}};
    for (size_t k = 0; k < kTraits; ++k) {
      const TraitResult& result = traits.results[k];
      OrderedJson& entry = json[std::string(name_of(static_cast<Trait>(k)))];
      entry["value"] = result.value ? OrderedJson(*result.value) : OrderedJson();
      entry["verdict"] = result.verdict ? OrderedJson(symbol_of(*result.verdict)) : OrderedJson();
    }
    json["paper_e"] = claim_text(traits.id);
    json["failure"] = traits.failure;
    techniques.push_back(std::move(json));
  }
  return {{"traits", techniques}};
}

}  // namespace

int show_traits(const TraitsOptions& options, const GlobalOptions& global) {
  require_store(options.no_reuse, global);
  const Home home = find_home();
  const SceneSearch search = scene_search(global, home);
  std::vector<TechniqueRun> runs;
  for (const std::string& id : options.ids) runs.push_back(choose_technique(id, {}, home));
  if (runs.empty()) runs = all_techniques(home);
  std::vector<SceneJob> scenes;
  for (const std::string& name : trait_scene_names()) scenes.push_back(load_scene_job(name, search));
  const auto realtime = open_realtime_renderer(global, home);
  VerbCache cache = open_cache(global, global.out, !options.no_reuse);
  ProgressBar progress;
  const TraitInputs inputs{.scenes = scenes,
                           .renderers = {cache.reference(options.picture), cache.frames(*realtime)},
                           .neutral_bias = [&](const TechniqueRun& run) { return neutral_bias(run, home); },
                           .picture = options.picture,
                           .makers = cache.makers(*realtime),
                           .answers = &cache.answers()};
  const std::vector<TechniqueTraits> traits = measure_traits(runs, inputs, progress);
  progress.clear();
  print_reuse(cache);
  int code = kExitFine;
  for (const TechniqueTraits& technique : traits) {
    if (technique.failure.empty()) continue;
    print_error(fmt::format("{}: {}", technique.id, technique.failure));
    code = kExitGateFailed;
  }
  if (global.json) {
    print_json(to_json(traits));
  } else {
    print_answer(traits_text(traits));
  }
  return code;
}

int write_technique_doc(const std::string& results_file, const GlobalOptions& global) {
  const Results results = parse_results(read_file(results_file), results_file);
  const std::string text = technique_doc(list_techniques(find_home().techniques), results);
  if (global.out.empty()) {
    print_answer(text);
  } else {
    write_file_atomically(global.out, text);
    print_note(fmt::format("wrote {}", global.out));
  }
  return kExitFine;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "results/json/results_json.h"

#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"
#include "results/json/schemas.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

SceneResult read_scene(const Json& json) {
  SceneResult scene;
  scene.name = json.at("name");
  scene.title = json.at("title");
  scene.doc = json.at("doc");
  scene.hash = json.at("hash");
  scene.light_name = json.at("light").at("name");
  scene.light_type = json.at("light").at("type");
  if (json.contains("animated")) scene.animated = read_animated(json.at("animated"));  // older ones have none
  scene.triangles = json.at("triangles");
  scene.quantity = json.at("quantity");
  scene.warnings = json.at("warnings").get<std::vector<std::string>>();
  scene.failure = read_failure(json.at("failure"));
  scene.reference = read_reference(json.at("reference"));
  scene.parity = read_parity(json.at("parity"));
  for (const Json& run : json.at("techniques")) scene.techniques.push_back(read_technique(run));
  return scene;
}

Results read_results(const Json& json) {
  Results results;
  results.version = json.at("version");
  results.commit = json.at("commit");
  results.quality = json.at("quality");
  results.picture = read_picture_quality(json);
  for (const Json& scene : json.at("scenes")) results.scenes.push_back(read_scene(scene));
  for (const Json& skip : json.at("skipped")) {
    results.skipped.push_back({skip.at("scene"), skip.at("technique"), skip.at("reason"),
                               read_optional<double>(skip.value("saved_s", Json()))});
  }
  return results;
}

}  // namespace

Results parse_results(std::string_view text, const std::string& file) {
  try {
    const Json json = Json::parse(text);
    require_schema(json, kResultsSchema, file);
    return read_results(json);
  } catch (const nlohmann::json::exception& error) {  // a foreign exception becomes ours here
    fail_input(fmt::format("not a results file: {}", error.what()), {file});
  }
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "results/json/results_json.h"

#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"
#include "results/json/schemas.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson scene_json(const SceneResult& scene) {
  OrderedJson techniques = OrderedJson::array();
  for (const TechniqueResult& run : scene.techniques) techniques.push_back(technique_json(run));
  return {{"name", scene.name},
          {"title", scene.title},
          {"doc", scene.doc},
          {"hash", scene.hash},
          {"light", {{"name", scene.light_name}, {"type", scene.light_type}}},
          {"animated", animated_json(scene.animated)},
          {"triangles", scene.triangles},
          {"quantity", scene.quantity},
          {"warnings", scene.warnings},
          {"failure", failure_json(scene.failure)},
          {"reference", reference_json(scene.reference)},
          {"parity", parity_json(scene.parity)},
          {"techniques", techniques}};
}

OrderedJson results_json(const Results& results) {
  OrderedJson scenes = OrderedJson::array();
  for (const SceneResult& scene : results.scenes) scenes.push_back(scene_json(scene));
  return {{"schema", kResultsSchema.number},
          {"version", results.version},
          {"commit", results.commit},
          {"quality", results.quality},
          {"width_px", results.picture.width_px},
          {"height_px", results.picture.height_px},
          {"seed", results.picture.seed},
          {"samples_per_pixel", results.picture.samples_per_pixel},
          {"target_se", optional_json(results.picture.target_se)},
          {"parity_passes", parity_passes(results)},
          {"scenes", scenes},
          {"skipped", skips_json(results.skipped)}};
}

OrderedJson work_json(const WorkDone& work) {
  return {{"rendered", work.rendered},
          {"reused", work.reused},
          {"references_rendered", work.references_rendered},
          {"references_reused", work.references_reused}};
}

}  // namespace

std::string to_json_text(const Results& results) {
  return dump(results_json(results));
}

std::string to_json_text_with_work(const Results& results) {
  OrderedJson json = results_json(results);
  json["work"] = work_json(results.work);
  return dump(json);
}

}  // namespace umbrameter

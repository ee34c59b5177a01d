// SPDX-License-Identifier: Apache-2.0
#include "study/results_json.h"

#include "study/catalogue.h"
#include "study/diagnosis_json.h"
#include "study/json_optional.h"
#include "study/json_parts.h"
#include "study/judgement_json.h"
#include "study/run_json.h"
#include "study/similarity_json.h"

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
  return {{"schema", kResultsSchema},
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

OrderedJson picture_json(const PictureScore& picture, const std::string& test_file,
                         const std::string& reference_file) {
  const Score& score = picture.score;
  const ParityNumbers numbers = parity_numbers(score.parity, ParityTolerance{}.required_agreement);
  OrderedJson parity = parity_json(score.has_surfaces ? std::optional(numbers) : std::nullopt);
  if (!parity.is_null()) parity.erase("picture_file");
  OrderedJson json{{"test", test_file},
                   {"reference", reference_file},
                   {"quantity", to_text(picture.quantity)},
                   {"quantity_given", picture.is_quantity_given},
                   {"other_rmse", interval_json(picture.other_rmse)},
                   {"parity", parity},
                   {"scorable_pixels", score.scorable_pixels},
                   {"error", score.error ? error_json(*score.error) : OrderedJson(nullptr)},
                   {"lit_rmse", optional_json(score.lit_rmse)}};
  add_judgement(score.judgement, json);
  add_diagnosis(score.diagnosis, json);
  json["similarity"] = similarity_json(score.similarity);
  json["measurements"] = measurements_json(result_of(score));
  json["no_diagnosis"] = failure_json(score.no_diagnosis);
  json["notes"] = picture.notes;
  json["mean_square_rounding"] = picture.mean_square_rounding;
  return json;
}

}  // namespace umbrameter

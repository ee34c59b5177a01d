// SPDX-License-Identifier: Apache-2.0
#include "results/bench/bench_json.h"

#include "results/bench/recommend.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"
#include "results/json/schemas.h"

#include <cmath>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson entry_json(const BenchEntry& entry) {
  TechniqueResult run = entry;
  run.pass_times = summarise(entry.times);
  OrderedJson json = technique_json(run);
  json["seed"] = entry.seed;
  json["compares_per_pixel"] = optional_json(entry.compares_per_pixel);
  json["time_ms"] = interval_json(entry.time_ms);
  json["is_software"] = entry.is_software;
  json["is_on_front"] = entry.has_place ? OrderedJson(!entry.dominated_by) : OrderedJson(nullptr);
  json["dominated_by"] = optional_json(entry.dominated_by);
  return json;
}

/// Infinity, which JSON lacks, is null: "at least".
OrderedJson paper_json(const PaperRatio& paper) {
  return {{"low", paper.low},
          {"high", std::isinf(paper.high) ? OrderedJson(nullptr) : OrderedJson(paper.high)}};
}

OrderedJson claim_json(const ClaimResult& result, const Claim& claim) {
  OrderedJson json{{"text", claim.text},
                   {"source", claim.source},
                   {"quantity", to_text(claim.quantity)},
                   {"without", claim.without},
                   {"numerator", claim.numerator},
                   {"denominator", claim.denominator},
                   {"unequal_cost", claim.has_unequal_cost},
                   {"compares_per_pixel", OrderedJson::array({optional_json(result.compares_per_pixel[0]),
                                                              optional_json(result.compares_per_pixel[1])})},
                   {"paper", paper_json(result.paper)},
                   {"ours", interval_json(result.ours)},
                   {"verdict", verdict_text(result)},
                   {"reason", result.reason}};
  if (claim.quantity == Quantity::pass_time) json["pass"] = claim.pass;
  return json;
}

OrderedJson ranking_json(const Ranking& ranking, const BenchScene& scene) {
  OrderedJson labels = OrderedJson::array();
  for (const size_t i : ranking) labels.push_back(scene.entries[i].label);
  return labels;
}

OrderedJson truth_json(const TruthCurve& truth) {
  OrderedJson points = OrderedJson::array();
  for (const TruthPoint& point : truth.points) {
    const auto rmse = [&](double Interval::*part) {
      return point.rmse ? OrderedJson((*point.rmse).*part) : OrderedJson(nullptr);
    };
    points.push_back({{"kind", point.kind},
                      {"setting", point.setting},
                      {"cpu_s", point.cpu_s.median},
                      {"cpu_mad_s", point.cpu_s.mad},
                      {"rays_per_pixel", point.rays_per_pixel},
                      {"rmse", rmse(&Interval::value)},
                      {"rmse_low", rmse(&Interval::low)},
                      {"rmse_high", rmse(&Interval::high)}});
  }
  return {{"points", points}, {"exponent", optional_json(truth.exponent)}};
}

OrderedJson scene_json(const BenchScene& scene, const BenchPlan& plan, const BenchQueries& queries) {
  OrderedJson entries = OrderedJson::array();
  for (const BenchEntry& entry : scene.entries) entries.push_back(entry_json(entry));
  OrderedJson claims = OrderedJson::array();
  for (const ClaimResult& result : scene.claims)
    claims.push_back(claim_json(result, plan.claims.at(result.claim)));
  OrderedJson json{{"name", scene.name},
                   {"scene", scene.scene},
                   {"camera", scene.camera},
                   {"title", scene.title},
                   {"hash", scene.hash},
                   {"light", scene.light},
                   {"triangles", scene.triangles},
                   {"warnings", scene.warnings},
                   {"failure", failure_json(scene.failure)},
                   {"reference_device", scene.reference_device},
                   {"parity", parity_json(scene.parity)},
                   {"runs", entries},
                   {"claims", claims}};
  if (!json["parity"].is_null()) json["parity"].erase("picture_file");
  if (scene.truth) json["truth"] = truth_json(*scene.truth);
  const auto best = recommended(scene.entries);
  json["recommended"] = best ? OrderedJson(scene.entries[*best].label) : OrderedJson(nullptr);
  if (queries.best_under_ms)
    json["best_under"] = ranking_json(best_under(scene.entries, *queries.best_under_ms), scene);
  if (queries.cheapest_below_rmse)
    json["cheapest_below_rmse"] =
        ranking_json(cheapest_below_rmse(scene.entries, *queries.cheapest_below_rmse), scene);
  return json;
}

OrderedJson overall_json(const std::optional<OverallRecommendation>& overall) {
  if (!overall) return nullptr;
  return {{"label", overall->label}, {"cost", overall->cost}, {"scenes", overall->scenes}};
}

}  // namespace

std::string to_json_text(const BenchResults& results, const BenchQueries& queries) {
  const BenchPlan& plan = results.plan;
  OrderedJson scenes = OrderedJson::array();
  for (const BenchScene& scene : results.scenes) scenes.push_back(scene_json(scene, plan, queries));
  return dump({{"schema", kBenchSchema.number},
               {"version", results.version},
               {"commit", results.commit},
               {"study", plan.file},
               {"title", plan.title},
               {"doc", plan.doc},
               {"quality", plan.quality},
               {"width_px", plan.picture.width_px},
               {"height_px", plan.picture.height_px},
               {"samples_per_pixel", plan.picture.samples_per_pixel},
               {"target_se", optional_json(plan.picture.target_se)},
               {"reference_seed", plan.picture.seed},
               {"wanted_frames", plan.timing.wanted_frames},
               {"frame_budget_s", plan.timing.budget_s},
               {"note", is_software(results) ? kSoftwareNote : ""},
               {"best_under_ms", optional_json(queries.best_under_ms)},
               {"rmse_limit", optional_json(queries.cheapest_below_rmse)},
               {"recommended", overall_json(recommended_overall(results.scenes))},
               {"scenes", scenes},
               {"skipped", skips_json(results.skipped)}});
}

}  // namespace umbrameter

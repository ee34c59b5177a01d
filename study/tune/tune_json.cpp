// SPDX-License-Identifier: Apache-2.0
#include "study/tune/tune_json.h"

#include "core/version.h"
#include "study/json_optional.h"
#include "study/json_parts.h"
#include "study/tune/tune_files.h"

#include <cmath>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity.
Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json score_json(const ViewScore& score) {
  return {{"view", score.view},
          {"held_out", score.is_held_out},
          {"value", score.objective ? Json(score.objective->value) : Json(nullptr)},
          {"interval", interval_json(score.objective ? score.objective->interval : std::nullopt)}};
}

Json candidate_json(const Candidate& candidate) {
  Json scores = Json::array();
  for (const ViewScore& score : candidate.scores) scores.push_back(score_json(score));
  return {{"name", candidate.name},
          {"same_cost", candidate.same_cost},
          {"ratio", finite(candidate.ratio)},
          {"held_out_ratio", candidate.held_out_ratio ? finite(*candidate.held_out_ratio) : Json(nullptr)},
          {"gain", interval_json(candidate.gain)},
          {"held_out_gain", interval_json(candidate.held_out_gain)},
          {"scores", scores},
          {"parameters", parameters_json(candidate.values)}};
}

Json length_json(const BiasSweep& sweep, const std::optional<double>& bias) {
  if (!bias) return nullptr;
  return {{"texels", optional_json(sweep.texels(*bias))}, {"world", optional_json(sweep.world(*bias))}};
}

Json sweep_json(const BiasSweep& sweep) {
  Json bias = Json::array(), objective = Json::array(), acne = Json::array(), peter_panning = Json::array();
  for (const BiasPoint& point : sweep.points) {
    bias.push_back(point.bias);
    objective.push_back(point.objective);
    acne.push_back(point.shares.acne);
    peter_panning.push_back(point.shares.peter_panning);
  }
  return {{"parameter", sweep.parameter},
          {"unit", sweep.unit},
          {"texel_world", sweep.texel_world},
          {"tolerance_share", kWindowTolerance},
          {"is_complete", sweep.is_complete},
          {"has_window", sweep.has_window()},
          {"acne_free_from", length_json(sweep, sweep.acne_free_from)},
          {"peter_pan_free_to", length_json(sweep, sweep.peter_pan_free_to)},
          {"bias", bias},
          {"objective", objective},
          {"acne_share", acne},
          {"peter_panning_share", peter_panning}};
}

Json trials_json(const std::vector<Trial>& trials, const std::vector<std::string>& tuned) {
  Json all = Json::array();
  for (const Trial& trial : trials) {
    ParameterValues values;
    for (const std::string& name : tuned) values[name] = trial.values.at(name);
    all.push_back({{"ratio", finite(trial.objective)}, {"parameters", parameters_json(values)}});
  }
  return all;
}

Json grid_json(const std::optional<GridCheck>& grid) {
  if (!grid) return nullptr;
  return {{"evaluations", grid->evaluations},
          {"best_ratio", finite(grid->best_ratio)},
          {"best", parameters_json(grid->best)}};
}

}  // namespace

std::string to_json_text(const TunePlan& plan, const TuneResult& result) {
  Json others = Json::array(), sweeps = Json::array(), sensitivities = Json::array();
  for (const Candidate& candidate : result.others) others.push_back(candidate_json(candidate));
  for (const BiasSweep& sweep : result.bias_sweeps) sweeps.push_back(sweep_json(sweep));
  for (const Sensitivity& one : result.sensitivities) {
    sensitivities.push_back({{"parameter", one.parameter},
                             {"rise_below", optional_json(one.rise_below)},
                             {"rise_above", optional_json(one.rise_above)},
                             {"relative_spread", one.relative_spread}});
  }
  return dump({{"schema", 1},
               {"version", kVersion},
               {"commit", kCommit},
               {"scenes", result.scenes},
               {"technique", plan.technique.id},
               {"hash", plan.technique.hash},
               {"objective", name_of(plan.objective)},
               {"unit", unit_of(plan.objective)},
               {"width_px", plan.full.width_px},
               {"height_px", plan.full.height_px},
               {"seed", plan.seed},
               {"device", result.device},
               {"wall_time_s", result.wall_time_s},
               {"tuned", result.tuned},
               {"coarse_evaluations", result.coarse_evaluations},
               {"evaluations", result.evaluations},
               {"is_converged", result.is_converged},
               {"best", candidate_json(result.best)},
               {"others", others},
               {"bias_sweep", sweeps},
               {"sensitivity", sensitivities},
               {"grid", grid_json(result.grid)},
               {"engine", engine_block(plan, result)},
               {"coarse_trials", trials_json(result.coarse_trials, result.tuned)},
               {"trials", trials_json(result.full_trials, result.tuned)},
               {"notes", result.notes}});
}

}  // namespace umbrameter

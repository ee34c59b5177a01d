// SPDX-License-Identifier: Apache-2.0
#include "results/tune/tune_json.h"

#include "core/version.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/schemas.h"
#include "results/tune/tune_files.h"

#include <cmath>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// JSON has no infinity.
OrderedJson finite(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

OrderedJson score_json(const ViewScore& score) {
  return {{"view", score.view},
          {"held_out", score.is_held_out},
          {"value", score.objective ? OrderedJson(score.objective->value) : OrderedJson(nullptr)},
          {"interval", interval_json(score.objective ? score.objective->interval : std::nullopt)}};
}

OrderedJson candidate_json(const Candidate& candidate) {
  OrderedJson scores = OrderedJson::array();
  for (const ViewScore& score : candidate.scores) scores.push_back(score_json(score));
  return {
      {"name", candidate.name},
      {"same_cost", candidate.same_cost},
      {"ratio", finite(candidate.ratio)},
      {"held_out_ratio", candidate.held_out_ratio ? finite(*candidate.held_out_ratio) : OrderedJson(nullptr)},
      {"gain", interval_json(candidate.gain)},
      {"held_out_gain", interval_json(candidate.held_out_gain)},
      {"scores", scores},
      {"parameters", parameters_json(candidate.values)}};
}

OrderedJson end_json(const SafeWindow& window, const std::optional<double>& end, double texel_world) {
  if (!end) return nullptr;
  if (window.kind == WindowKind::light_size) return *end;
  return {{"value", *end},
          {"texels", optional_json(in_texels(window.unit, *end, texel_world))},
          {"world", optional_json(in_world_units(window.unit, *end, texel_world))}};
}

/// How a kind of window is called in the file.
struct WindowNames {
  const char *from, *to, *value, *too_low, *too_high;
};
constexpr WindowNames kBiasNames{"acne_free_from", "peter_pan_free_to", "bias", "acne_share",
                                 "peter_panning_share"};
constexpr WindowNames kSizeNames{"hard_free_from", "soft_free_to", "scale", "too_hard_octaves",
                                 "too_soft_octaves"};

OrderedJson window_json(const SafeWindow& window, double texel_world) {
  OrderedJson value = OrderedJson::array(), objective = OrderedJson::array(), too_low = OrderedJson::array(),
              too_high = OrderedJson::array();
  for (const WindowPoint& point : window.points) {
    value.push_back(point.value);
    objective.push_back(point.objective);
    too_low.push_back(point.too_low);
    too_high.push_back(point.too_high);
  }
  const WindowNames& names = window.kind == WindowKind::bias ? kBiasNames : kSizeNames;
  return {{"parameter", window.parameter},
          {"unit", window.unit},
          {"beside", window.is_at_tuned ? "tuned" : "given"},
          {"texel_world", texel_world},
          {"tolerance", tolerance_of(window.kind)},
          {"is_complete", window.is_complete},
          {"has_window", window.has_window()},
          {names.from, end_json(window, window.from, texel_world)},
          {names.to, end_json(window, window.to, texel_world)},
          {names.value, value},
          {"objective", objective},
          {names.too_low, too_low},
          {names.too_high, too_high}};
}

OrderedJson windows_json(const TuneResult& result, WindowKind kind) {
  OrderedJson all = OrderedJson::array();
  for (const SafeWindow& window : result.windows) {
    if (window.kind == kind) all.push_back(window_json(window, result.texel_world));
  }
  return all;
}

OrderedJson trials_json(const std::vector<TuneTrial>& trials, const std::vector<std::string>& tuned) {
  OrderedJson all = OrderedJson::array();
  for (const TuneTrial& trial : trials) {
    ParameterValues values;
    for (const std::string& name : tuned) values[name] = trial.values.at(name);
    all.push_back({{"ratio", finite(trial.objective)}, {"parameters", parameters_json(values)}});
  }
  return all;
}

OrderedJson grid_json(const std::optional<GridCheck>& grid) {
  if (!grid) return nullptr;
  return {{"evaluations", grid->evaluations},
          {"best_ratio", finite(grid->best_ratio)},
          {"best", parameters_json(grid->best)}};
}

}  // namespace

namespace {

OrderedJson tuning_json(const TuneResult& result) {
  OrderedJson others = OrderedJson::array(), sensitivities = OrderedJson::array();
  for (const Candidate& candidate : result.others) others.push_back(candidate_json(candidate));
  for (const Sensitivity& one : result.sensitivities) {
    sensitivities.push_back({{"parameter", one.parameter},
                             {"rise_below", optional_json(one.rise_below)},
                             {"rise_above", optional_json(one.rise_above)},
                             {"relative_spread", one.relative_spread}});
  }
  return {{"schema", kTuneSchema.number},
          {"version", kVersion},
          {"commit", kCommit},
          {"scenes", result.scenes},
          {"technique", result.head.technique},
          {"hash", result.head.hash},
          {"objective", name_of(result.head.objective)},
          {"unit", unit_of(result.head.objective)},
          {"width_px", result.head.width_px},
          {"height_px", result.head.height_px},
          {"seed", result.head.seed},
          {"device", result.device},
          {"wall_time_s", result.wall_time_s},
          {"tuned", result.tuned},
          {"coarse_evaluations", result.coarse_evaluations},
          {"evaluations", result.evaluations},
          {"is_converged", result.is_converged},
          {"best", candidate_json(result.best)},
          {"others", others},
          {"bias_sweep", windows_json(result, WindowKind::bias)},
          {"light_size_sweep", windows_json(result, WindowKind::light_size)},
          {"sensitivity", sensitivities},
          {"grid", grid_json(result.grid)},
          {"engine", engine_block(result)},
          {"coarse_trials", trials_json(result.coarse_trials, result.tuned)},
          {"trials", trials_json(result.full_trials, result.tuned)},
          {"notes", result.notes}};
}

OrderedJson lit_sum_json(const LitSum& sum) {
  return {{"scene", sum.scene},
          {"pixels", sum.pixels},
          {"lit_rmse_as_given", interval_json(sum.before)},
          {"lit_rmse_tuned", interval_json(sum.after)},
          {"outcome", name_of(sum.outcome)}};
}

}  // namespace

std::string to_json_text(const TuneResult& result) {
  return dump(tuning_json(result));
}

std::string lights_json_text(std::span<const LightTuning> tunings, std::span<const LitSum> sums) {
  OrderedJson lights = OrderedJson::array(), lit = OrderedJson::array();
  for (const LightTuning& one : tunings)
    lights.push_back({{"light", one.light}, {"tuning", tuning_json(*one.result)}});
  for (const LitSum& sum : sums) lit.push_back(lit_sum_json(sum));
  return dump({{"schema", kTuneSchema.number}, {"lights", lights}, {"lit_sums", lit}});
}

}  // namespace umbrameter

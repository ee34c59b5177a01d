// SPDX-License-Identifier: Apache-2.0
#include "results/catalogue.h"
#include "results/json/causes_json.h"
#include "results/json/diagnosis_json.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/judgement_json.h"
#include "results/json/run_json.h"
#include "results/json/similarity_json.h"

namespace umbrameter {

using OrderedJson = nlohmann::ordered_json;

namespace {

OrderedJson region_json(const RegionError& region) {
  return {{"pixels", region.pixels},
          {"share", region.share},
          {"mse", region.mse},
          {"rmse", optional_json(region_rmse(region))},
          {"bias", region.bias}};
}

OrderedJson temporal_json(const std::optional<TemporalNumbers>& temporal) {
  if (!temporal) return nullptr;
  return {{"frames", temporal->frames},
          {"camera",
           {{"points", temporal->camera.points},
            {"rejected", temporal->camera.rejected},
            {"test", optional_json(temporal->camera.test)},
            {"reference", optional_json(temporal->camera.reference)},
            {"excess", optional_json(temporal->camera.excess)}}},
          {"light", {{"pixels", temporal->light.pixels}, {"rms", optional_json(temporal->light.rms)}}},
          {"seed_noise", optional_json(temporal->seed_noise)}};
}

OrderedJson gate_json(const std::optional<RowGate>& gate) {
  if (!gate) return nullptr;
  return {{"class", name_of(gate->kind)}, {"excess", gate->limit.excess}, {"share", gate->limit.share}};
}

OrderedJson term_json(const std::optional<ObjectiveTerm>& term) {
  if (!term) return nullptr;
  return {{"name", term->name}, {"one", term->one}};
}

}  // namespace

OrderedJson error_json(const VisibilityError& error) {
  return {{"scored_pixels", error.scored_pixels},
          {"mse", interval_json(error.mse)},
          {"rmse", interval_json(error.rmse)},
          {"mae", optional_json(error.mae)},
          {"bias", optional_json(error.bias)},
          {"over_shadowing", optional_json(error.over_shadowing)},
          {"under_shadowing", optional_json(error.under_shadowing)},
          {"noise_floor_mse", optional_json(error.noise_floor_mse)},
          {"max_error", optional_json(error.max_error)},
          {"lit", region_json(error.lit)},
          {"umbra", region_json(error.umbra)},
          {"penumbra", region_json(error.penumbra)}};
}

OrderedJson catalogue_json() {
  OrderedJson rows = OrderedJson::array();
  for (const Metric& metric : metric_catalogue()) {
    rows.push_back({{"key", metric.key},
                    {"label", metric.label},
                    {"group", metric.group},
                    {"unit", metric.unit},
                    {"better", name_of(metric.better)},
                    {"form", name_of(metric.form)},
                    {"needs", name_of(metric.needs)},
                    {"gate", gate_json(metric.gate)},
                    {"term", term_json(metric.term)},
                    {"doc", metric.doc}});
  }
  return rows;
}

OrderedJson measurements_json(const TechniqueResult& run) {
  OrderedJson values = OrderedJson::object();
  for (const Metric& metric : metric_catalogue()) {
    if (const auto value = metric.of(run)) values[metric.key] = *value;
  }
  return values;
}

void add_measures(const TechniqueResult& run, OrderedJson& json) {
  json["error"] = run.error ? error_json(*run.error) : OrderedJson(nullptr);
  json["lit_rmse"] = optional_json(run.lit_rmse);
  add_judgement(run.judgement, json);
  add_diagnosis(run.diagnosis, json);
  json["similarity"] = similarity_json(run.similarity);
  json["measurements"] = measurements_json(run);
}

OrderedJson technique_json(const TechniqueResult& run) {
  OrderedJson json{{"label", run.label},
                   {"technique", run.technique},
                   {"title", run.title},
                   {"quantity", run.quantity},
                   {"hash", run.hash},
                   {"parameters", parameters_json(run.parameters)},
                   {"failure", failure_json(run.failure)},
                   {"clipped_share", run.clipped_share},
                   {"pass_times", times_json(run.pass_times)},
                   {"timer", run.timer},
                   {"device", run.device},
                   {"memory_bytes", run.memory_bytes},
                   {"wall_time_s", run.wall_time_s},
                   {"warnings", run.warnings},
                   {"left_out", run.left_out},
                   {"measured_at", run.measured_at},
                   {"image_file", run.image_file},
                   {"picture_file", run.picture_file},
                   {"error_picture_file", run.error_picture_file},
                   {"fault_picture_file", run.fault_picture_file}};
  if (run.frames_before > 0) {
    json["frames_before"] = run.frames_before;
    json["motion"] = run.motion;
  }
  add_measures(run, json);
  if (run.fault_causes) json["fault_causes"] = fault_causes_json(run.fault_causes);
  json["temporal"] = temporal_json(run.temporal);
  json["maps_file"] = run.maps_file;
  return json;
}

OrderedJson reference_json(const std::optional<ReferenceResult>& reference) {
  if (!reference) return nullptr;
  return {{"device", reference->device},
          {"wall_time_s", reference->wall_time_s},
          {"mean_visibility_se", reference->mean_visibility_se},
          {"max_visibility_se", reference->max_visibility_se},
          {"mean_sample_count", reference->mean_sample_count},
          {"scorable_pixels", reference->scorable_pixels},
          {"model_gap_rmse", optional_json(reference->model_gap_rmse)},
          {"model_gap_lit_rmse", optional_json(reference->model_gap_lit_rmse)},
          {"proven_lit_share", reference->proven_lit_share},
          {"proven_dark_share", reference->proven_dark_share},
          {"warnings", reference->warnings},
          {"measured_at", reference->measured_at},
          {"image_file", reference->image_file},
          {"picture_file", reference->picture_file}};
}

}  // namespace umbrameter

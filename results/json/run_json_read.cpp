// SPDX-License-Identifier: Apache-2.0
#include "results/json/run_json.h"

#include "results/catalogue.h"
#include "results/json/causes_json.h"
#include "results/json/diagnosis_json.h"
#include "results/json/json_optional.h"
#include "results/json/judgement_json.h"
#include "results/json/similarity_json.h"

namespace umbrameter {
namespace {

using Json = nlohmann::json;

RegionError read_region(const Json& json) {
  return {json.at("pixels"), json.at("share"), json.at("mse"), json.at("bias")};
}

std::optional<VisibilityError> read_error(const Json& json) {
  if (json.is_null()) return std::nullopt;
  VisibilityError error;
  error.scored_pixels = json.at("scored_pixels");
  error.mse = read_interval(json.at("mse"));
  error.rmse = read_interval(json.at("rmse"));
  error.mae = read_optional<double>(json.at("mae"));
  error.bias = read_optional<double>(json.at("bias"));
  error.over_shadowing = read_optional<double>(json.at("over_shadowing"));
  error.under_shadowing = read_optional<double>(json.at("under_shadowing"));
  error.noise_floor_mse = read_optional<double>(json.at("noise_floor_mse"));
  error.max_error = read_optional<double>(json.at("max_error"));
  error.lit = read_region(json.at("lit"));
  error.umbra = read_region(json.at("umbra"));
  error.penumbra = read_region(json.at("penumbra"));
  return error;
}

ErrorKind read_kind(const std::string& text) {
  if (text == "input") return ErrorKind::input;
  if (text == "environment") return ErrorKind::environment;
  if (text == "cancelled") return ErrorKind::cancelled;
  return ErrorKind::internal;
}

ParameterValue read_value(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<int64_t>();
  if (json.is_number()) return json.get<double>();
  return json.get<std::string>();
}

/// Those that nothing else holds. Files of before rows lack them.
std::map<std::string, double> read_measured(const Json& values) {
  std::map<std::string, double> measured;
  for (const Metric& metric : metric_catalogue()) {
    if (metric.measure && values.contains(metric.key)) measured[metric.key] = values.at(metric.key);
  }
  return measured;
}

std::optional<TemporalNumbers> read_temporal(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const Json &camera = json.at("camera"), &light = json.at("light");
  return TemporalNumbers{
      json.at("frames"),
      {camera.at("points"), camera.at("rejected"), read_optional<double>(camera.at("test")),
       read_optional<double>(camera.at("reference")), read_optional<double>(camera.at("excess"))},
      {light.at("pixels"), read_optional<double>(light.at("rms"))},
      read_optional<double>(json.at("seed_noise"))};
}

}  // namespace

ParameterValues read_parameters(const Json& json) {
  ParameterValues values;
  for (const auto& [name, value] : json.items()) values[name] = read_value(value);
  return values;
}

std::optional<Interval> read_interval(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  return Interval{json.at("value"), json.at("low"), json.at("high")};
}

PictureQuality read_picture_quality(const nlohmann::json& json) {
  return {.width_px = json.at("width_px"),
          .height_px = json.at("height_px"),
          .samples_per_pixel = json.at("samples_per_pixel"),
          .target_se = read_optional<double>(json.at("target_se")),
          .seed = json.at("seed")};
}

std::vector<PassTime> read_times(const nlohmann::json& json) {
  std::vector<PassTime> times;
  for (const Json& time : json) {
    times.push_back({time.at("pass"), time.at("median_ms"), time.at("mad_ms"), time.at("frames")});
  }
  return times;
}

std::optional<Failure> read_failure(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  return Failure{read_kind(json.at("kind")), json.at("message")};
}

TechniqueResult read_technique(const nlohmann::json& json) {
  TechniqueResult run;
  run.label = json.at("label");
  run.technique = json.at("technique");
  run.title = json.at("title");
  run.quantity = json.value("quantity", run.quantity);
  run.hash = json.at("hash");
  run.parameters = read_parameters(json.at("parameters"));
  run.failure = read_failure(json.at("failure"));
  run.error = read_error(json.at("error"));
  run.lit_rmse = read_optional<double>(json.at("lit_rmse"));
  run.clipped_share = json.at("clipped_share");
  run.pass_times = read_times(json.at("pass_times"));
  run.timer = json.at("timer");
  run.device = json.at("device");
  run.memory_bytes = json.at("memory_bytes");
  run.wall_time_s = json.at("wall_time_s");
  run.warnings = json.at("warnings").get<std::vector<std::string>>();
  run.left_out = json.at("left_out").get<std::vector<std::string>>();
  run.frames_before = json.value("frames_before", 0);
  run.motion = json.value("motion", "");
  run.measured_at = json.at("measured_at");
  run.image_file = json.at("image_file");
  run.picture_file = json.at("picture_file");
  run.error_picture_file = json.at("error_picture_file");
  run.fault_picture_file = json.at("fault_picture_file");
  run.judgement = read_judgement(json);
  run.diagnosis = read_diagnosis(json);
  run.fault_causes = read_fault_causes(json.value("fault_causes", Json()));
  run.temporal = read_temporal(json.at("temporal"));
  run.similarity = read_similarity(json.at("similarity"));
  run.maps_file = json.at("maps_file");
  run.measured = read_measured(json.value("measurements", Json::object()));
  return run;
}

std::optional<ReferenceResult> read_reference(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  ReferenceResult reference;
  reference.device = json.at("device");
  reference.wall_time_s = json.at("wall_time_s");
  reference.mean_visibility_se = json.at("mean_visibility_se");
  reference.max_visibility_se = json.at("max_visibility_se");
  reference.mean_sample_count = json.at("mean_sample_count");
  reference.scorable_pixels = json.at("scorable_pixels");
  reference.model_gap_rmse = read_optional<double>(json.at("model_gap_rmse"));
  reference.model_gap_lit_rmse = read_optional<double>(json.at("model_gap_lit_rmse"));
  reference.proven_lit_share = json.at("proven_lit_share");
  reference.proven_dark_share = json.at("proven_dark_share");
  reference.measured_at = json.at("measured_at");
  reference.warnings = json.at("warnings").get<std::vector<std::string>>();
  reference.image_file = json.at("image_file");
  reference.picture_file = json.at("picture_file");
  return reference;
}

std::optional<ParityNumbers> read_parity(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  ParityNumbers parity;
  parity.passes = json.at("passes");
  parity.agreement = json.at("agreement");
  parity.required_agreement = json.at("required_agreement");
  parity.covered = json.at("covered");
  parity.coverage_mismatch = json.at("coverage_mismatch");
  parity.surface_mismatch = json.at("surface_mismatch");
  parity.irradiance_mismatch = json.at("irradiance_mismatch");
  parity.same_primitive = json.at("same_primitive");
  parity.median_relative_depth_error = json.at("median_relative_depth_error");
  parity.picture_file = json.at("picture_file");
  return parity;
}

}  // namespace umbrameter

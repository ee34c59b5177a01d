// SPDX-License-Identifier: Apache-2.0
#include "results/regress/case_json.h"

#include "results/json/json_parts.h"

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson mean_json(const MeanWithNoise& mean) {
  return {{"value", mean.value}, {"sd", mean.sd}};
}

MeanWithNoise read_mean(const nlohmann::json& json) {
  return {json.at("value"), json.at("sd")};
}

OrderedJson numbers_json(const CaseNumbers& numbers) {
  return {{"scored_pixels", numbers.scored_pixels},
          {"mse", interval_json(numbers.mse)},
          {"noise_sd", numbers.noise_sd},
          {"seed_sd", numbers.seed_sd},
          {"measures", numbers.measures}};
}

CaseNumbers read_numbers(const nlohmann::json& json) {
  const nlohmann::json& mse = json.at("mse");
  return {json.at("scored_pixels"),
          {mse.at("value"), mse.at("low"), mse.at("high")},
          json.at("noise_sd"),
          json.at("seed_sd"),
          json.at("measures")};
}

}  // namespace

OrderedJson answer_json(const TruthNumbers& numbers) {
  return {{"hash", numbers.hash},
          {"device", numbers.device},
          {"seed", numbers.seed},
          {"samples_per_pixel", numbers.samples_per_pixel},
          {"visibility", mean_json(numbers.visibility)},
          {"penumbra", mean_json(numbers.penumbra)}};
}

void read_answer(const nlohmann::json& json, TruthNumbers& numbers) {
  numbers = {json.at("hash"),
             json.at("device"),
             json.at("seed"),
             json.at("samples_per_pixel"),
             read_mean(json.at("visibility")),
             read_mean(json.at("penumbra"))};
}

OrderedJson answer_json(const Measured& measured, const BaselineRun& described) {
  OrderedJson json = {{"parameters", described.parameters}, {"device", described.device}};
  if (measured.numbers) json["numbers"] = numbers_json(*measured.numbers);
  if (measured.voided)
    json["void"] = {{"kind", measured.voided->kind}, {"message", measured.voided->message}};
  return json;
}

void read_answer(const nlohmann::json& json, Measured& measured, BaselineRun& described) {
  described.parameters = json.at("parameters");
  described.device = json.at("device");
  measured = {};
  if (json.contains("numbers")) measured.numbers = read_numbers(json["numbers"]);
  if (!json.contains("void")) return;
  const nlohmann::json& voided = json["void"];
  measured.voided = not_compared(voided.at("kind"), voided.at("message"));
}

}  // namespace umbrameter

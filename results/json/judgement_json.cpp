// SPDX-License-Identifier: Apache-2.0
#include "results/json/judgement_json.h"

#include "results/json/json_optional.h"

#include <string>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

// Our own names; an unknown one means that nothing was decided.
Comparison read_comparison(const std::string& text) {
  for (const Comparison outcome : {Comparison::better, Comparison::worse, Comparison::same}) {
    if (text == name_of(outcome)) return outcome;
  }
  return Comparison::cannot_tell;
}

LimitOutcome read_limit_outcome(const std::string& text) {
  for (const LimitOutcome outcome : {LimitOutcome::pass, LimitOutcome::fail}) {
    if (text == name_of(outcome)) return outcome;
  }
  return LimitOutcome::cannot_tell;
}

OrderedJson significance_json(const SignificanceNumbers& numbers) {
  return {{"tested", numbers.tested},
          {"too_dark", numbers.too_dark},
          {"too_bright", numbers.too_bright},
          {"threshold_z", optional_json(numbers.threshold_z)},
          {"exceeding", numbers.exceeding},
          {"expected_exceeding", optional_json(numbers.expected_exceeding)},
          {"exceedance_sigmas", optional_json(numbers.exceedance_sigmas)}};
}

SignificanceNumbers read_significance(const Json& json) {
  return {json.at("tested"),
          json.at("too_dark"),
          json.at("too_bright"),
          read_optional<double>(json.at("threshold_z")),
          json.at("exceeding"),
          read_optional<double>(json.at("expected_exceeding")),
          read_optional<double>(json.at("exceedance_sigmas"))};
}

OrderedJson verdict_json(const RunVerdict& verdict) {
  const Interval& difference = verdict.mse_difference;
  return {
      {"baseline", verdict.baseline},
      {"outcome", name_of(verdict.outcome)},
      {"mse_difference", {{"value", difference.value}, {"low", difference.low}, {"high", difference.high}}},
      {"more_samples", optional_json(verdict.more_samples)}};
}

RunVerdict read_verdict(const Json& json) {
  const Json& difference = json.at("mse_difference");
  return {json.at("baseline"), read_comparison(json.at("outcome")),
          Interval{difference.at("value"), difference.at("low"), difference.at("high")},
          read_optional<double>(json.at("more_samples"))};
}

OrderedJson limit_json(const LimitNumbers& limit) {
  return {{"rmse", limit.limit_rmse},
          {"outcome", name_of(limit.outcome)},
          {"more_samples", optional_json(limit.more_samples)}};
}

}  // namespace

void add_judgement(const Judgement& judgement, nlohmann::ordered_json& object) {
  const auto& [significance, verdict, limit] = judgement;
  object["significance"] = significance ? significance_json(*significance) : OrderedJson(nullptr);
  object["verdict"] = verdict ? verdict_json(*verdict) : OrderedJson(nullptr);
  object["limit"] = limit ? limit_json(*limit) : OrderedJson(nullptr);
}

Judgement read_judgement(const nlohmann::json& object) {
  Judgement out;
  if (!object.at("significance").is_null()) out.significance = read_significance(object.at("significance"));
  if (!object.at("verdict").is_null()) out.verdict = read_verdict(object.at("verdict"));
  const Json& limit = object.at("limit");
  if (!limit.is_null()) {
    out.limit = LimitNumbers{limit.at("rmse"), read_limit_outcome(limit.at("outcome")),
                             read_optional<double>(limit.at("more_samples"))};
  }
  return out;
}

}  // namespace umbrameter

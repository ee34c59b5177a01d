// SPDX-License-Identifier: Apache-2.0
#include "results/json/causes_json.h"

#include "results/causes_format.h"
#include "results/json/json_optional.h"

#include <algorithm>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

OrderedJson faults_json(const FaultCauses& causes) {
  const std::vector<std::string> sentences = cause_sentences(causes);
  OrderedJson faults = OrderedJson::array();
  for (size_t i = 0; i < causes.faults.size(); ++i) {
    const CausedFault& fault = causes.faults[i];
    const SubstitutionOutcome* cause = cause_of(causes, i);
    faults.push_back({{"fault", name_of(fault.fault)},
                      {"pixels", fault.pixels},
                      {"mean_abs_error", fault.mean_abs_error},
                      {"cause", cause == nullptr ? OrderedJson(nullptr) : OrderedJson(cause->id)},
                      {"sentence", sentences[i]}});
  }
  return faults;
}

OrderedJson outcome_json(const SubstitutionOutcome& outcome) {
  const bool is_measured = !outcome.not_tried;
  return {{"id", outcome.id},
          {"changes", outcome.changes},
          {"not_tried", optional_json(outcome.not_tried)},
          {"removed", is_measured ? OrderedJson(outcome.removed) : OrderedJson(nullptr)},
          {"elsewhere", is_measured ? OrderedJson(outcome.elsewhere) : OrderedJson(nullptr)}};
}

FaultClass read_class(const Json& json) {
  for (size_t k = 0; k < kFaultClasses; ++k) {
    const auto fault = static_cast<FaultClass>(k);
    if (json.get<std::string>() == name_of(fault)) return fault;
  }
  throw Json::other_error::create(501, "no fault class: " + json.dump(), &json);
}

SubstitutionOutcome read_outcome(const Json& json) {
  SubstitutionOutcome outcome;
  outcome.id = json.at("id");
  outcome.changes = json.at("changes").get<std::vector<std::string>>();
  outcome.not_tried = read_optional<std::string>(json.at("not_tried"));
  if (outcome.not_tried) return outcome;
  outcome.removed = json.at("removed").get<std::vector<double>>();
  outcome.elsewhere = json.at("elsewhere");
  return outcome;
}

}  // namespace

OrderedJson fault_causes_json(const std::optional<FaultCauses>& causes) {
  if (!causes) return nullptr;
  OrderedJson outcomes = OrderedJson::array();
  for (const SubstitutionOutcome& outcome : causes->outcomes) outcomes.push_back(outcome_json(outcome));
  return {{"skipped", optional_json(causes->skipped)}, {"faults", faults_json(*causes)}, {"tried", outcomes}};
}

std::optional<FaultCauses> read_fault_causes(const Json& json) {
  if (json.is_null()) return std::nullopt;
  FaultCauses causes;
  causes.skipped = read_optional<std::string>(json.at("skipped"));
  for (const Json& fault : json.at("faults"))
    causes.faults.push_back({read_class(fault.at("fault")), fault.at("pixels"), fault.at("mean_abs_error")});
  for (const Json& outcome : json.at("tried")) causes.outcomes.push_back(read_outcome(outcome));
  return causes;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "results/selftest/trial_json.h"

#include "results/json/json_optional.h"

#include <cmath>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// A name that is none is of another version.
template <class Kind>
Kind kind_named(const nlohmann::json& json, size_t count) {
  const std::string name = json;
  for (size_t k = 0; k < count; ++k) {
    if (name_of(static_cast<Kind>(k)) == name) return static_cast<Kind>(k);
  }
  throw nlohmann::json::other_error::create(501, "no such kind: " + name, &json);
}

/// JSON has no infinity.
OrderedJson number_json(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

double read_number(const nlohmann::json& json) {
  return json.is_null() ? HUGE_VAL : json.get<double>();
}

OrderedJson tried_json(const SubstitutionOutcome& tried) {
  return {{"id", tried.id},
          {"changes", tried.changes},
          {"not_tried", optional_json(tried.not_tried)},
          {"removed", tried.removed},
          {"elsewhere", tried.elsewhere}};
}

SubstitutionOutcome read_tried(const nlohmann::json& json) {
  return {json.at("id"), json.at("changes"), read_optional<std::string>(json.at("not_tried")),
          json.at("removed"), json.at("elsewhere")};
}

}  // namespace

OrderedJson trial_json(const GateVerdict& verdict) {
  OrderedJson measures = OrderedJson::array();
  for (const GateMeasure& one : verdict.measures) {
    measures.push_back({{"kind", name_of(one.kind)},
                        {"value", optional_json(one.value)},
                        {"baseline", optional_json(one.baseline)},
                        {"allowed", number_json(one.allowed)},
                        {"key", one.key}});
  }
  return {{"measures", std::move(measures)},
          {"kind", verdict.kind ? OrderedJson(name_of(*verdict.kind)) : OrderedJson(nullptr)},
          {"key", verdict.key}};
}

void read_trial(const nlohmann::json& json, GateVerdict& verdict) {
  verdict = {};
  for (const nlohmann::json& one : json.at("measures")) {
    verdict.measures.push_back(
        {kind_named<GateClass>(one.at("kind"), kGateClasses), read_optional<double>(one.at("value")),
         read_optional<double>(one.at("baseline")), read_number(one.at("allowed")), one.at("key")});
  }
  verdict.key = json.at("key");
  if (!json.at("kind").is_null()) verdict.kind = kind_named<GateClass>(json["kind"], kGateClasses);
}

OrderedJson trial_json(const Unresolved& unresolved) {
  return {{"edges", optional_json(unresolved.edges)}, {"shade", unresolved.shade}};
}

void read_trial(const nlohmann::json& json, Unresolved& unresolved) {
  unresolved = {read_optional<double>(json.at("edges")), json.at("shade")};
}

OrderedJson trial_json(const std::optional<MaskOutcome>& outcome) {
  if (!outcome) return {{"mask", nullptr}};
  return {{"mask", outcome->name},
          {"scene", outcome->scene},
          {"width_px", outcome->round.width_px},
          {"height_px", outcome->round.height_px},
          {"seed", outcome->round.seed},
          {"fault", name_of(outcome->fault)},
          {"painted", outcome->painted},
          {"found", outcome->found},
          {"both", outcome->both}};
}

void read_trial(const nlohmann::json& json, std::optional<MaskOutcome>& outcome) {
  outcome.reset();
  if (json.at("mask").is_null()) return;
  const SelftestRound round{json.at("width_px"), json.at("height_px"), json.at("seed")};
  outcome = MaskOutcome{json["mask"],
                        json.at("scene"),
                        round,
                        kind_named<FaultClass>(json.at("fault"), kFaultClasses),
                        json.at("painted"),
                        json.at("found"),
                        json.at("both")};
}

OrderedJson trial_json(const CauseOutcome& outcome) {
  OrderedJson right = OrderedJson::array(), tried = OrderedJson::array();
  for (const RunPart part : outcome.right) right.push_back(name_of(part));
  for (const SubstitutionOutcome& one : outcome.tried) tried.push_back(tried_json(one));
  return {{"name", outcome.name},
          {"scene", outcome.scene},
          {"right", std::move(right)},
          {"fault", outcome.fault ? OrderedJson(name_of(*outcome.fault)) : OrderedJson(nullptr)},
          {"tried", std::move(tried)},
          {"best", outcome.best},
          {"removed", outcome.removed},
          {"undone", outcome.undone},
          {"cause", outcome.cause ? OrderedJson(name_of(*outcome.cause)) : OrderedJson(nullptr)}};
}

void read_trial(const nlohmann::json& json, CauseOutcome& outcome) {
  constexpr size_t kRunParts = static_cast<size_t>(RunPart::blocker_distance) + 1;
  outcome = {};
  outcome.name = json.at("name");
  outcome.scene = json.at("scene");
  for (const nlohmann::json& part : json.at("right"))
    outcome.right.push_back(kind_named<RunPart>(part, kRunParts));
  if (!json.at("fault").is_null()) outcome.fault = kind_named<FaultClass>(json["fault"], kFaultClasses);
  for (const nlohmann::json& one : json.at("tried")) outcome.tried.push_back(read_tried(one));
  outcome.best = json.at("best");
  outcome.removed = json.at("removed");
  outcome.undone = json.at("undone");
  if (!json.at("cause").is_null()) outcome.cause = kind_named<RunPart>(json["cause"], kRunParts);
}

OrderedJson trial_json(const HardeningOutcome& outcome) {
  const ContactHardening& exact = outcome.exact;
  return {{"scene", outcome.scene},
          {"penumbrae", outcome.penumbrae},
          {"profiles", exact.profiles},
          {"octaves", exact.octaves},
          {"slope", optional_json(exact.slope)},
          {"intercept_octaves", optional_json(exact.intercept_octaves)},
          {"slope_margin", optional_json(exact.slope_margin)}};
}

void read_trial(const nlohmann::json& json, HardeningOutcome& outcome) {
  outcome = {};
  outcome.scene = json.at("scene");
  outcome.penumbrae = json.at("penumbrae");
  outcome.exact = {json.at("profiles"), json.at("octaves"), read_optional<double>(json.at("slope")),
                   read_optional<double>(json.at("intercept_octaves")),
                   read_optional<double>(json.at("slope_margin"))};
}

}  // namespace umbrameter

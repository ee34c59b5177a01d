// SPDX-License-Identifier: Apache-2.0
#include "results/stress/outcome.h"

#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, kStressOutcomes> kOutcomeNames = {
    "ok",       "worse",    "other_surfaces", "nothing",   "rightly_refused", "refused",     "not_applicable",
    "unjudged", "accepted", "wrong_truth",    "bad_value", "gl_error",        "environment", "bug",
    "crash",    "hang"};

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

std::string_view name_of(StressOutcome outcome) {
  return kOutcomeNames[static_cast<size_t>(outcome)];
}

StressOutcome stress_outcome(std::string_view name) {
  const auto found = std::ranges::find(kOutcomeNames, name);
  UMBRAMETER_ASSERT(found != kOutcomeNames.end(), "no outcome is called '{}'", name);
  return static_cast<StressOutcome>(found - kOutcomeNames.begin());
}

bool breaks_rules(StressOutcome outcome) {
  using enum StressOutcome;
  constexpr std::array kBroken = {accepted, wrong_truth, bad_value, gl_error, bug, crash, hang};
  return std::ranges::find(kBroken, outcome) != kBroken.end();
}

nlohmann::ordered_json cell_json(const StressCell& cell) {
  return {{"axis", cell.axis},
          {"row", cell.row},
          {"value", cell.value},
          {"outcome", name_of(cell.outcome)},
          {"how", cell.how},
          {"rmse", interval_json(cell.rmse)},
          {"scored_pixels", cell.scored_pixels},
          {"exact_points", cell.exact_points},
          {"warnings", cell.warnings}};
}

StressCell read_cell(const nlohmann::json& json) {
  StressCell cell;
  cell.axis = json.at("axis");
  cell.row = json.at("row");
  cell.value = json.at("value");
  cell.outcome = stress_outcome(json.at("outcome").get<std::string>());
  cell.how = json.at("how");
  cell.rmse = read_interval(json.at("rmse"));
  cell.scored_pixels = json.at("scored_pixels");
  cell.exact_points = json.at("exact_points");
  cell.warnings = json.at("warnings");
  return cell;
}

StressOutcome outcome_of(const Failure& failure) {
  // realtime/executor/check_visibility.h and realtime/harness/debug_log.h
  if (holds(failure.message, "gives visibility")) return StressOutcome::bad_value;
  if (holds(failure.message, "OpenGL reported")) return StressOutcome::gl_error;
  switch (failure.kind) {
    case ErrorKind::input:
      return StressOutcome::refused;
    case ErrorKind::environment:
      return StressOutcome::environment;
    default:
      return StressOutcome::bug;
  }
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A sweep's plan and outcome, and what a store holds, as text and JSON.

#include "results/json/export.h"
#include "study/grid/screen.h"
#include "study/grid/sweep.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>

namespace umbrameter {

/// Steps of one scene with the same reason share a line.
std::string plan_text(const SweepPlan& plan, std::span<const StudyScene> scenes,
                      std::span<const PlanStep> steps);
nlohmann::ordered_json plan_json(const SweepPlan& plan, std::span<const StudyScene> scenes,
                                 std::span<const PlanStep> steps);

std::string idle_text(std::span<const IdleParameter> idle, std::span<const StudyScene> scenes);
nlohmann::ordered_json idle_json(std::span<const IdleParameter> idle, std::span<const StudyScene> scenes);

std::string outcome_text(const SweepOutcome& outcome);
nlohmann::ordered_json outcome_json(const SweepOutcome& outcome);

/// Ranked by RMSE within a scene.
std::string stored_text(const StoredRuns& runs);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Outcomes of trials as a store keeps them. What reads throws nlohmann::json::exception for another version's.

#include "results/selftest/outcome.h"

#include <nlohmann/json.hpp>
#include <optional>

namespace umbrameter {

nlohmann::ordered_json trial_json(const GateVerdict& verdict);
nlohmann::ordered_json trial_json(const Unresolved& unresolved);
nlohmann::ordered_json trial_json(const std::optional<MaskOutcome>& outcome);
nlohmann::ordered_json trial_json(const CauseOutcome& outcome);
nlohmann::ordered_json trial_json(const HardeningOutcome& outcome);
void read_trial(const nlohmann::json& json, GateVerdict& verdict);
void read_trial(const nlohmann::json& json, Unresolved& unresolved);
void read_trial(const nlohmann::json& json, std::optional<MaskOutcome>& outcome);
void read_trial(const nlohmann::json& json, CauseOutcome& outcome);
void read_trial(const nlohmann::json& json, HardeningOutcome& outcome);

}  // namespace umbrameter

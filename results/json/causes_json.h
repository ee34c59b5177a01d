// SPDX-License-Identifier: Apache-2.0
#pragma once
// Causes by substitution in results.json and in the store (docs/results.md).

#include "metrics/causes/fault_causes.h"

#include <nlohmann/json.hpp>

namespace umbrameter {

/// null when absent.
nlohmann::ordered_json fault_causes_json(const std::optional<FaultCauses>& causes);
/// Throws nlohmann::json::exception for anything else.
std::optional<FaultCauses> read_fault_causes(const nlohmann::json& json);

}  // namespace umbrameter

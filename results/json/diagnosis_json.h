// SPDX-License-Identifier: Apache-2.0
#pragma once
// Diagnosis <-> the keys `penumbra`, `contact_hardening`, `faults`, `moire` and `causes` of results.json
// (docs/results.md).

#include "metrics/diagnosis.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace umbrameter {

/// Sets these keys of `object`, to null without a diagnosis.
void add_diagnosis(const std::optional<Diagnosis>& diagnosis, nlohmann::ordered_json& object);

/// Reads them back; absent when `penumbra` is null. nlohmann::json::exception for anything else.
std::optional<Diagnosis> read_diagnosis(const nlohmann::json& object);

}  // namespace umbrameter

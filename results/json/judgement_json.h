// SPDX-License-Identifier: Apache-2.0
#pragma once
// Judgement <-> the keys `significance`, `verdict` and `limit` of results.json (docs/results.md).

#include "metrics/judgement.h"

#include <nlohmann/json.hpp>

namespace umbrameter {

/// Sets the three keys of `object`, to null where there is nothing.
void add_judgement(const Judgement& judgement, nlohmann::ordered_json& object);

/// Reads them back. nlohmann::json::exception for anything else.
Judgement read_judgement(const nlohmann::json& object);

}  // namespace umbrameter

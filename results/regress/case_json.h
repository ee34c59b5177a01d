// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a regression has measured, as a store keeps it. What reads throws nlohmann::json::exception for another
// version's.

#include "results/regress/outcome.h"

#include <nlohmann/json_fwd.hpp>

namespace umbrameter {

nlohmann::ordered_json answer_json(const TruthNumbers& numbers);
void read_answer(const nlohmann::json& json, TruthNumbers& numbers);

/// With the run's parameters and device, as they were when it was drawn.
nlohmann::ordered_json answer_json(const Measured& measured, const BaselineRun& described);
void read_answer(const nlohmann::json& json, Measured& measured, BaselineRun& described);

}  // namespace umbrameter

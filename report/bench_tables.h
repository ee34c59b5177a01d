// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tables of a scene of a bench, from its JSON (docs/studies.md). A key that is missing throws a JSON exception.

#include <nlohmann/json.hpp>

#include <string>

namespace umbrameter {

std::string bench_runs_table(const nlohmann::ordered_json& scene);
/// Empty without claims.
std::string bench_claims_table(const nlohmann::ordered_json& scene);
/// Empty without the truth's curve.
std::string bench_truth_table(const nlohmann::ordered_json& scene);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What results.json and bench.json have in common. Absent values are null.

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

nlohmann::ordered_json interval_json(const std::optional<Interval>& interval);
nlohmann::ordered_json failure_json(const std::optional<Failure>& failure);
nlohmann::ordered_json parameters_json(const ParameterValues& parameters);
nlohmann::ordered_json times_json(const std::vector<PassTime>& times);
nlohmann::ordered_json parity_json(const std::optional<ParityNumbers>& parity);
nlohmann::ordered_json animated_json(const std::vector<AnimatedMesh>& meshes);
std::vector<AnimatedMesh> read_animated(const nlohmann::json& json);
nlohmann::ordered_json skips_json(const std::vector<Skip>& skipped);

/// Indented, ending in a newline. Text from drivers and file names need not be UTF-8; a replacement character is better
/// than a throw.
std::string dump(const nlohmann::ordered_json& json);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `tune` left beside the results: bias sweeps with their safe windows, and the best parameters.

#include <nlohmann/json.hpp>

#include <filesystem>

namespace umbrameter {

/// The sweeps of every tune*.json in `folder`, by file name: {file, parameter, unit, values, objective, acne,
/// peter_panning, window {low, high, empty}} and, where the file says so, scene and technique. Error{input} naming the file
/// when one is malformed.
nlohmann::ordered_json read_bias_sweeps(const std::filesystem::path& folder);

/// What each of them found best: {file, technique, scenes, objective, tuned, sensitivity, best, others}, as
/// in docs/tuning.md.
nlohmann::ordered_json read_tunings(const std::filesystem::path& folder);

}  // namespace umbrameter

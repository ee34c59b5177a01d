// SPDX-License-Identifier: Apache-2.0
#pragma once
// What results.json says of a run and of the truth (docs/results.md): the one writer and the one reader of such entries,
// in results.json and in the store.

#include "results/results.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <vector>

namespace umbrameter {

nlohmann::ordered_json error_json(const VisibilityError& error);
/// The rows of the catalogue, for programs and the page.
nlohmann::ordered_json catalogue_json();
/// Each row of the catalogue that has a value, by its key.
nlohmann::ordered_json measurements_json(const TechniqueResult& run);
/// What a picture got against the truth: the same keys wherever a run stands.
void add_measures(const TechniqueResult& run, nlohmann::ordered_json& json);
nlohmann::ordered_json technique_json(const TechniqueResult& run);
nlohmann::ordered_json reference_json(const std::optional<ReferenceResult>& reference);

// Readers throw nlohmann::json::exception for anything else.
std::optional<Interval> read_interval(const nlohmann::json& json);
/// The numbers of a picture, which stand beside others.
PictureQuality read_picture_quality(const nlohmann::json& json);
ParameterValues read_parameters(const nlohmann::json& json);
std::vector<PassTime> read_times(const nlohmann::json& json);
std::optional<Failure> read_failure(const nlohmann::json& json);
TechniqueResult read_technique(const nlohmann::json& json);
std::optional<ReferenceResult> read_reference(const nlohmann::json& json);
std::optional<ParityNumbers> read_parity(const nlohmann::json& json);

}  // namespace umbrameter

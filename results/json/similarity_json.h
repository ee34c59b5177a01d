// SPDX-License-Identifier: Apache-2.0
#pragma once
// Second opinions in results.json and in the store (docs/results.md).

#include "metrics/error/lit_similarity.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace umbrameter {

/// Null when absent; psnr_db is null for equal pictures, too, and comes back infinite.
nlohmann::ordered_json similarity_json(const std::optional<Similarity>& similarity);
/// Throws nlohmann::json::exception for anything else.
std::optional<Similarity> read_similarity(const nlohmann::json& json);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Absent values are null.

#include <nlohmann/json.hpp>

#include <optional>

namespace umbrameter {

template <class T>
nlohmann::ordered_json optional_json(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

template <class T>
std::optional<T> read_optional(const nlohmann::json& json) {
  return json.is_null() ? std::nullopt : std::optional<T>(json.get<T>());
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Absent values are null.

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace umbrameter {

template <class T>
nlohmann::ordered_json optional_json(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

template <class T>
std::optional<T> read_optional(const nlohmann::json& json) {
  return json.is_null() ? std::nullopt : std::optional<T>(json.get<T>());
}

/// What `read` makes of a stored text: an optional. Absent without one, and where another version wrote it.
template <class Read>
auto read_json(const std::optional<std::string>& text, Read read) -> decltype(read(nlohmann::json())) {
  if (!text) return std::nullopt;
  try {
    return read(nlohmann::json::parse(*text));
  } catch (const nlohmann::json::exception&) {  // another version wrote it
    return std::nullopt;
  }
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What other verbs leave beside the results, for sections of their own: tune*.json, bench*.json, stress*.json, regress*.json.

#include "results/json/schemas.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace umbrameter {

/// `read(document, file name)` for every `folder`/<verb>*.json, by name; the schema is called as its verb. Error{input} naming the
/// file when it is no JSON, of another schema, or when `read` throws a JSON exception: it is not as the verb writes it.
using ReadSideFile = std::function<void(const nlohmann::ordered_json& document, const std::string& file)>;
void for_side_files(const std::filesystem::path& folder, const FileSchema& schema, const ReadSideFile& read);

/// The text under `key`. Throws a JSON exception when there is none.
inline std::string text_of(const nlohmann::ordered_json& object, const char* key) {
  return object.at(key).get<std::string>();
}

/// All that a page of `folder` would read besides results.json.
std::vector<std::filesystem::path> side_files(const std::filesystem::path& folder);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Is all in a JSON document that the page's scripts will read of it?

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string_view>

namespace umbrameter {

/// Fields like "scenes[].runs[].rmse?.value:number": names along the way, [] for each item of a list, ? for what may be null, and
/// a type: number, text, flag, list or object. Throws a JSON exception that names the field when one is missing or of another type.
void require_fields(const nlohmann::ordered_json& document, std::span<const std::string_view> fields);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Results <-> results.json (docs/results.md).

#include "results/results.h"

#include <string>
#include <string_view>

namespace umbrameter {

/// The whole document, indented, ending in a newline; equal results give equal bytes.
std::string to_json_text(const Results& results);

/// The same with `work`: what this process rendered and reused.
std::string to_json_text_with_work(const Results& results);

/// Reads what to_json_text wrote. Error{input} naming `file` for anything else.
Results parse_results(std::string_view text, const std::string& file);

}  // namespace umbrameter

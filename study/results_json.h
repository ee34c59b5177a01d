// SPDX-License-Identifier: Apache-2.0
#pragma once
// Results <-> results.json (docs/results.md), and a lone score as JSON.

#include "study/results.h"
#include "study/score.h"

#include <string>
#include <string_view>

namespace umbrameter {

inline constexpr int kResultsSchema = 3;

/// The whole document, indented, ending in a newline; equal results give equal bytes.
std::string to_json_text(const Results& results);

/// The same with `work`: what this process rendered and reused.
std::string to_json_text_with_work(const Results& results);

/// Reads what to_json_text wrote. Error{input} naming `file` for anything else.
Results parse_results(std::string_view text, const std::string& file);

/// A lone score with the files it compared.
std::string to_json_text(const Score& score, const std::string& test_file, const std::string& reference_file);

}  // namespace umbrameter

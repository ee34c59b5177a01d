// SPDX-License-Identifier: Apache-2.0
#pragma once
// What reaches the terminal: answers on stdout, everything else on stderr.

#include "core/error.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// "umbrameter: error: <sentence>" on stderr, one line whatever the text holds.
void print_error(std::string_view sentence);
/// "umbrameter: warning: <sentence>" on stderr.
void print_warning(std::string_view sentence);
void print_warnings(const std::vector<std::string>& sentences);
/// "umbrameter: <sentence>" on stderr.
void print_note(std::string_view sentence);

/// Text or JSON on stdout; Error{environment} when it does not take it.
void print_answer(std::string_view text);
/// With `schema` first: the answer's own, or that of all answers without one (results/json/schemas.h).
void print_json(const nlohmann::ordered_json& answer);

/// Rows under their headings, columns aligned; every row has as many cells as `headings`.
std::string format_table(const std::vector<std::string>& headings,
                         const std::vector<std::vector<std::string>>& rows);

int exit_code(ErrorKind kind);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The exact oracle as another process: `umbrameter-exact`, beside this program (its licence differs, see
// reference/exact_answer.h).

#include "reference/exact_answer.h"

#include <filesystem>
#include <optional>

namespace umbrameter {

/// The program, when it lies beside this one.
std::optional<std::filesystem::path> find_exact_program();

/// Asks `program`. Error{environment} when it cannot be started, ends early or answers something else; its own words are in
/// the sentence.
ExactOracle exact_oracle_of(const std::filesystem::path& program);

/// That of find_exact_program(); Error{environment} says where it was looked for.
ExactOracle require_exact_oracle();

}  // namespace umbrameter

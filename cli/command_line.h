// SPDX-License-Identifier: Apache-2.0
#pragma once
// From words to a verb. Not here: running it (cli/main.cpp).

#include "cli/verbs.h"

#include <optional>

namespace umbrameter {

/// Sets `line`; an exit code when nothing is left to run: help was printed, or what is wrong. `argv` starts with the
/// program's name. `app` is empty and must outlive the run of the verb, as `line` must.
std::optional<int> parse_command_line(int argc, const char* const* argv, CLI::App& app, CommandLine& line);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The verb that opens a window.

#include "cli/verbs.h"

namespace umbrameter {

void add_view(CLI::App& app, CommandLine& line);

}  // namespace umbrameter

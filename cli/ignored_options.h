// SPDX-License-Identifier: Apache-2.0
#pragma once
// Options that every verb takes and some do nothing with.

#include "cli/verbs.h"

namespace umbrameter {

/// Warns of each option that was given and that the parsed verb ignores.
void warn_of_ignored_options(const CLI::App& app);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// --motion, for verbs that render pictures with history.

#include "cli/verbs.h"

#include <string>

namespace umbrameter {

void add_motion_option(CLI::App& verb, std::string& motion);

}  // namespace umbrameter

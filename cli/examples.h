// SPDX-License-Identifier: Apache-2.0
#pragma once
// Examples of each verb: in its --help, and in the manual page.

#include "cli/verbs.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Whole command lines, by path ("scene check"); empty for verbs that have none.
std::vector<std::string> examples_of(const std::string& verb_path);

/// Puts them under every verb's help, above what stands there.
void add_examples(CLI::App& app);

}  // namespace umbrameter

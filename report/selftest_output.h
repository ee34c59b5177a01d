// SPDX-License-Identifier: Apache-2.0
#pragma once
// The selftest's matrix for people (also docs/selftest.md) and for programs.

#include "results/selftest/outcome.h"

#include <string>

namespace umbrameter {

/// Markdown: faults by what the gate measured (in what is allowed, above 1 fails), benign variants by scene, masks,
/// and what was reached.
std::string selftest_markdown(const SelftestResults& results);

/// One JSON object.
std::string selftest_json(const SelftestResults& results);

}  // namespace umbrameter

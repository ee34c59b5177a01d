// SPDX-License-Identifier: Apache-2.0
#pragma once
// The selftest's faults against baselines that have been through their text (docs/regress.md).

#include "cli/verbs.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Prints what became of each; kExitGateFailed when one is missed or too few are named. No `scenes`: all faults.
int prove_regress(const std::vector<std::string>& scenes, const GlobalOptions& global);

}  // namespace umbrameter

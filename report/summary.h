// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a reader should know first.

#include "study/results.h"

#include <string>

namespace umbrameter {

/// Failures, void comparisons, the verdicts counted, and each scene's best.
std::string summary_verdicts(const Results& results);

}  // namespace umbrameter

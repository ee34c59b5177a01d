// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a reader should know first.

#include "results/results.h"

#include <nlohmann/json.hpp>

namespace umbrameter {

/// {problems, counts, scenes}: failures and void comparisons in sentences, the verdicts counted, and what keeps each scene from
/// having numbers (empty: nothing).
nlohmann::ordered_json summary_verdicts(const Results& results);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Causes by substitution as people read them; the terminal, the JSON and the report show the same text.

#include "metrics/causes/fault_causes.h"

#include "results/diagnosis_format.h"

#include <string>
#include <vector>

namespace umbrameter {

/// One per fault: "peter panning 0.02800: no bias mends it; the truth's blocker distance removes 91 %: the search does not
/// find the blockers' true distance".
std::vector<std::string> cause_sentences(const FaultCauses& causes);

/// "cause" and its sentence for each fault; or why none was looked for.
TermLines substitution_lines(const FaultCauses& causes);

/// A table of substitution by fault: its name, what of each fault it removes ("91 %", "worse x 2.3"), the error elsewhere.
/// Rows of cells, the head first.
std::vector<std::vector<std::string>> cause_table(const FaultCauses& causes);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A check as others read it: people, CI servers, programs. Not here: the page (report/assets/regress.js).

#include "results/regress/outcome.h"

#include <span>
#include <string>

namespace umbrameter {

/// One line a case that does not simply pass, and a summary.
std::string regress_text(const RegressResults& results);

/// Before and after of every case, as a table.
std::string regress_markdown(const RegressResults& results);

/// What became of faults that were put in.
std::string proof_markdown(std::span<const ProvedFault> faults);

/// Everything (docs/regress.md), as the report reads it.
std::string regress_json(const RegressResults& results);

/// JUnit's XML: a test suite a scene, a test case a run. Characters that XML has no place for become '?'.
std::string junit_xml(const RegressResults& results);

/// GitHub's workflow commands: an error a failure, a warning an undecided case.
std::string github_annotations(const RegressResults& results);

}  // namespace umbrameter

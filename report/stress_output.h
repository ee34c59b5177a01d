// SPDX-License-Identifier: Apache-2.0
#pragma once
// A stress run as others read it: people, and programs such as the page of report/.

#include "study/stress/summary.h"

#include <string>

namespace umbrameter {

/// Techniques down, axes across would be too wide for a terminal: one line an axis and range, techniques that share it
/// together; then what breaks the rules.
std::string stress_text(const StressResults& results);

/// docs/stability.md's tables.
std::string stress_markdown(const StressResults& results);

/// stress.json.
std::string stress_json(const StressResults& results);

/// One line: counts and settings.
std::string stress_summary(const StressResults& results);

/// A violation as a sentence.
std::string violation_text(const StressResults& results, const StressCell& cell);

}  // namespace umbrameter

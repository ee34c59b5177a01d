// SPDX-License-Identifier: Apache-2.0
#pragma once
// The report's summary table.

#include "study/results.h"

#include <string>

namespace umbrameter {

/// <tr> rows, one a scene and technique, failed ones included.
std::string summary_rows(const Results& results);

/// Anchor of a scene's section, and of a run's numbers in it; the page's scripts know them, too.
std::string scene_anchor(size_t scene_index);
std::string run_anchor(size_t scene_index, size_t run_index);

/// "pass", "fail" or "cannot tell".
std::string format_limit(const LimitNumbers& limit);

}  // namespace umbrameter

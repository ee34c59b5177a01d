#pragma once
// The report's summary table.

#include "study/results.h"

#include <string>

namespace umbrameter {

/// <tr> rows, one a scene and technique, failed ones included.
std::string summary_rows(const Results& results);

/// Anchor of a scene's section.
std::string scene_anchor(size_t scene_index);

}  // namespace umbrameter

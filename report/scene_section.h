// SPDX-License-Identifier: Apache-2.0
#pragma once
// One scene of the report: what it is, the place of its pictures, and every run's numbers.

#include "study/results.h"

#include <string>

namespace umbrameter {

/// The pictures themselves come from the page's planes (report/page_data.h).
std::string scene_section(const Results& results, size_t scene_index);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Everything known of a reference or a run as a description list, with the context that made it.

#include "study/results.h"

#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// <div><dt>..</dt><dd>..</dd></div> rows, escaped.
std::string reference_facts(const Results& results, const SceneResult& scene);
std::string run_facts(const Results& results, const SceneResult& scene, const TechniqueResult& run);

/// <li> items, escaped.
std::string list_items(const std::vector<std::string>& texts);

}  // namespace umbrameter

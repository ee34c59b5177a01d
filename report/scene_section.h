#pragma once
// One scene of the report: its pictures, each with the context that made it.

#include "study/results.h"

#include <filesystem>
#include <string>

namespace umbrameter {

std::string scene_section(const Results& results, size_t scene_index, const std::filesystem::path& folder);

/// <li> items, escaped.
std::string list_items(const std::vector<std::string>& texts);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Before and after: what `regress check` found, with the gates' numbers.

#include "study/results.h"

#include <filesystem>
#include <string>

namespace umbrameter {

struct RegressPart {
  std::string verdict;  // for the summary
  std::string html;
};

/// Of every regress*.json in `folder` (docs/regress.md); empty without one. Cases link to their runs among `results`.
/// Error{input} naming the file when one is malformed.
RegressPart regress_part(const std::filesystem::path& folder, const Results& results);

}  // namespace umbrameter

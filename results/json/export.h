// SPDX-License-Identifier: Apache-2.0
#pragma once
// A store's runs as a list, as JSON and as CSV (docs/store.md).

#include "results/json/record.h"

#include <string>
#include <vector>

namespace umbrameter {

struct StoredRuns {
  std::vector<RunRecord> runs;  // by scene, label, seed and size
  size_t older = 0;             // left out: the same run made again by other code or on another device
  size_t foreign = 0;           // left out: written by another version
};

/// Indented, ending in a newline.
std::string to_json_text(const StoredRuns& runs);

/// One line a run; parameters have a column each, "parameter.<name>", empty where a run has none of that name.
std::string to_csv(const StoredRuns& runs);

}  // namespace umbrameter

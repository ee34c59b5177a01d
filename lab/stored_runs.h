// SPDX-License-Identifier: Apache-2.0
#pragma once
// The runs that a store holds.

#include "results/json/export.h"
#include "results/json/record.h"
#include "store/store.h"

#include <optional>
#include <string>

namespace umbrameter {

/// Puts a run into the store.
void keep_record(Store& store, const std::string& key, const RunRecord& record);

/// The run under a key. Absent where there is none that this version reads.
std::optional<RunRecord> find_record(Store& store, const std::string& key);

/// With `all` also those that were made again since. Without verdicts: see judge_runs.
StoredRuns stored_runs(Store& store, bool all);

}  // namespace umbrameter

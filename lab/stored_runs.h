// SPDX-License-Identifier: Apache-2.0
#pragma once
// The runs that a store holds.

#include "results/json/export.h"
#include "store/store.h"

namespace umbrameter {

/// With `all` also those that were made again since. Without verdicts: see judge_runs.
StoredRuns stored_runs(Store& store, bool all);

}  // namespace umbrameter

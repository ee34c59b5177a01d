// SPDX-License-Identifier: Apache-2.0
#pragma once
// The runs of a store as the results of a validation, so that a page can show what a sweep left (docs/store.md).

#include "results/results.h"
#include "store/store.h"

#include <optional>

namespace umbrameter {

/// A scene for every truth that runs of the store were compared with, in the order of stored_runs(); each run with its
/// verdict. Names of images are those of objects, relative to the store's folder. Size, samples and seed are those of the
/// first run. Absent when the store holds no run of this version.
std::optional<Results> stored_results(Store& store);

}  // namespace umbrameter

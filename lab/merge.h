// SPDX-License-Identifier: Apache-2.0
#pragma once
// Several stores become one, as if one process had filled it.

#include "store/store.h"

#include <cstddef>

namespace umbrameter {

struct MergeCounts {
  size_t added = 0;
  size_t present = 0;  // already there
};

/// Adds to `into` what `from` has and it has not. A result takes the place of a failed run; images go along. What is
/// damaged in `from` stays behind with a warning there.
MergeCounts merge_store(Store& from, Store& into);

}  // namespace umbrameter

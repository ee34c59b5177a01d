// SPDX-License-Identifier: Apache-2.0
#pragma once
// What skips have saved, estimated from the times of what was not skipped.

#include "results/results.h"

namespace umbrameter {

/// Lists, scene by scene, the pixels of proven visibility that got no rays, and estimates what every skip saved: runs
/// by the median of the same run in other scenes, else of the scene's other runs; truths by their time for the other pixels.
void add_savings(Results& results);

}  // namespace umbrameter

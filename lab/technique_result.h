// SPDX-License-Identifier: Apache-2.0
#pragma once
// From a run to what is said of it, before it is scored.

#include "lab/technique_run.h"
#include "lab/timing.h"
#include "results/results.h"

namespace umbrameter {

/// Nothing is known but what was asked.
TechniqueResult describe(const TechniqueRun& run);

/// What a run that has not failed says of its frames, all but the image.
void take_frame(const TimedRun& run, TechniqueResult& result);

}  // namespace umbrameter

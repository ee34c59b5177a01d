// SPDX-License-Identifier: Apache-2.0
#pragma once
// From a run to what is said of it, before it is scored.

#include "lab/timing.h"
#include "results/json/record.h"
#include "results/results.h"
#include "results/technique_run.h"

namespace umbrameter {

/// Nothing is known but what was asked.
TechniqueResult describe(const TechniqueRun& run);

/// Of the run, without results. `reference`: key of its truth.
RunRecord make_record(const TechniqueRun& run, RecordHead head, const std::string& reference);

/// What a picture says of its run, all but the picture.
void take_frame(const Frame& frame, TechniqueResult& result);

/// What the frames of a run that has not failed say after it.
void take_times(const TimedRun& run, TechniqueResult& result);

}  // namespace umbrameter

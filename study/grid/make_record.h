// SPDX-License-Identifier: Apache-2.0
#pragma once
// From what was rendered and scored to what a sweep stores of it.

#include "lab/keys.h"
#include "lab/score.h"
#include "results/record.h"
#include "study/grid/bench.h"

#include <string>

namespace umbrameter {

/// Started now.
RecordHead make_head(const StudyScene& scene, PictureQuality picture, uint64_t seed);

/// Without results.
RunRecord make_record(const BenchRun& run, RecordHead head, const std::string& reference);

void take_score(const Score& score, RunRecord& record);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a bench finds in a store and leaves there: runs with their scores, as a sweep has them, and the times of a scene's runs,
// which were taken in turn and are of use only together.

#include "lab/score.h"
#include "results/json/record.h"
#include "study/grid/bench.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A run of a scene with what is kept of it. `record` is new, and then without numbers, where it is not known.
struct KeptRun {
  const BenchRun* run = nullptr;
  std::string key;  // of its entry
  RunRecord record;
  bool is_known = false;
};

/// What the store says of a run, under the entry's label.
void take_record(const RunRecord& record, BenchEntry& entry);

/// Every run with what is known of it.
std::vector<KeptRun> find_runs(BenchCache& cache, const StudyScene& job, const BenchPlan& plan,
                               std::span<const BenchRun* const> runs);

/// Fills the scene from its runs and their times, where all are known.
bool find_scene(BenchCache& cache, const BenchPlan& plan, std::span<const KeptRun> runs, BenchScene& scene);

/// Scores a run's first frame into its record and keeps it, so that it is not lost while frames are timed.
void keep_scored(BenchCache& cache, const Scene& scene, const Frame& frame, const Image& truth,
                 SharedTruth& shared, KeptRun& run);

/// Keeps the runs that were timed, failed, or could not be compared, and the times.
void keep_scene(BenchCache& cache, const BenchPlan& plan, std::span<KeptRun> runs, const BenchScene& scene);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `sweep` and `validate` keep of the same run differs: a sweep's has no pictures for people, a validation's no mask and no
// baseline. Here each finds the other's, so that neither renders what the other has (docs/store.md).

#include "lab/timing.h"
#include "lab/validation.h"
#include "lab/verdicts.h"
#include "results/json/record.h"
#include "store/lazy_store.h"

#include <optional>
#include <string>

namespace umbrameter {

/// As many as are wanted, or as the budget had room for.
bool has_enough_frames(const TechniqueResult& run, const TimingPlan& timing);

/// `run`: a run_key(). What a sweep keeps of it, where that answers all that `plan` asks for but pictures.
std::optional<RunRecord> find_swept(LazyStore& store, const std::string& run, const ValidationPlan& plan);

/// Notes that a validation keeps `run` under `validated`, a validated_run_key().
void note_validated(Store& store, const std::string& run, const std::string& validated);

/// What a store has of a run.
struct StoredRun {
  std::optional<RunRecord> record;  // absent where the run has to be rendered
  bool is_validation = false;       // a validation's: its picture has no mask, and it has no baseline
  std::string lack;                 // why it has to be rendered, for people
};

/// A sweep's or a validation's, with as many frames as has_enough_frames() asks for where `timing` is given. A run that failed
/// counts only if its failure stays: Error{input}.
StoredRun find_run(Store& store, const std::string& run, const std::optional<TimingPlan>& timing);

/// Its picture as a sweep keeps it.
StoredPicture swept_picture(const Store& store, const RunRecord& validated, const Image& truth,
                            const Camera& camera);

/// The rest of it, without pictures, of no scene's sweep yet.
RunRecord swept(RunRecord validated, const std::string& label);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// From what was rendered to what is stored of it: its score and its pictures.

#include "lab/keys.h"
#include "lab/score.h"
#include "lab/verdicts.h"
#include "results/json/record.h"

#include <string>

namespace umbrameter {

/// Where pictures go.
struct Keeper {
  Store& store;
  const std::filesystem::path& scratch;  // an existing folder for files in the making
  const Makers& makers;
};

struct KeptScore {
  StoredPicture picture;  // as the record names it; without a mask where nothing could be compared
  size_t scorable_pixels = 0;
};

/// Scores a run's picture against the truth into its record, and keeps what it needs: the picture, its faults', and parity
/// where that is not kept yet. The record's duration becomes that of its frame, result.wall_time_s, and of the score.
/// `shared` is of this truth. Throws what score_image() does.
KeptScore keep_score(const Keeper& keeper, const Scene& scene, const Image& picture, const Image& truth,
                     MetricChoice metrics, SharedTruth& shared, RunRecord& record);

}  // namespace umbrameter

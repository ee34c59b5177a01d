// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scores of pictures as validate's results: a folder with pictures, results.json and the page.

#include "cli/score_inputs.h"

#include <string>

namespace umbrameter {

/// A picture with its score; the baseline, too.
struct ScoredPicture {
  const EnginePicture& picture;
  const PictureScore& score;
};

/// Folder `out` (empty: none is kept) as validate fills it, and the page alone as `report` (empty: none).
void write_score_results(const ScoreInputs& inputs, const std::vector<ScoredPicture>& scored,
                         const ValidationPlan& plan, const std::string& report, const std::string& out);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A score as validate's results: a folder with pictures, results.json and the page.

#include "cli/score_inputs.h"
#include "study/score.h"

#include <string>

namespace umbrameter {

/// The rounding of pictures may be all of this much of the mean squared error: its interval gets so much longer below.
void widen_by_rounding(double mean_square_rounding, VisibilityError& error);

/// Folder `out` (empty: none is kept) as validate fills it, and the page alone as `report` (empty: none).
void write_score_results(const ScoreInputs& inputs, const ScoreSettings& settings, const std::string& report,
                         const std::string& out);

}  // namespace umbrameter

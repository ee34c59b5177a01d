// SPDX-License-Identifier: Apache-2.0
#pragma once
// One axis walked: every value for the truth and for every technique, a cell each. Not here: the process it happens in
// (cli/stress_worker.h) and what the cells say together (study/stress/summary.h).

#include "results/picture_quality.h"
#include "results/stress/journal.h"
#include "scenes/altered/stress/axis.h"
#include "study/stress/tools.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

struct StressPlan {
  std::string title;
  PictureQuality picture{.width_px = 128, .height_px = 96, .samples_per_pixel = 256};  // without a target
  int timeout_s = 300;                  // without a cell done: hangs
  std::vector<std::string> techniques;  // ids or folders; empty = all built-in ones
  std::vector<StressAxis> axes;
};

/// The values in the order they are run in: the nominal one first, as the others are judged by it.
std::vector<size_t> walking_order(const StressAxis& axis);

/// Cells of an axis with `techniques` techniques.
size_t cells_of(const StressAxis& axis, size_t techniques);

/// Runs what `done` lacks. Scenes go to folder/<value>/, and pictures of what is not ok if `keep_pictures`.
void run_stress_axis(const StressAxis& axis, const StressPlan& plan, const StressTools& tools,
                     const std::filesystem::path& folder, bool keep_pictures, const JournalState& done,
                     JournalWriter& journal, Progress& progress);

}  // namespace umbrameter

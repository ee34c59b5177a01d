// SPDX-License-Identifier: Apache-2.0
#pragma once
// The cells of an axis that a store knows (lab/answers.h), so that a walk goes on where it was killed.

#include "lab/answers.h"
#include "lab/keys.h"
#include "results/stress/outcome.h"
#include "scenes/altered/stress/axis.h"

#include <string>
#include <vector>

namespace umbrameter {

/// What a cell depends on, beside its axis.
struct StressKeys {
  PictureQuality picture;
  std::vector<TechniqueRun> techniques;
  Makers makers;
  bool has_oracle = false;  // truths are held against exact arithmetic
};

/// Every cell of the axis that is kept.
std::vector<StressCell> kept_cells(Answers& answers, const StressAxis& axis, const StressKeys& keys);

/// In the order in which a walk makes them.
void sort_cells(std::vector<StressCell>& cells, const StressAxis& axis, const StressKeys& keys);

/// Does nothing for a cell that says something about the machine: a crash, a hang, a lack of memory.
void keep_cell(Answers& answers, const StressAxis& axis, const StressKeys& keys, const StressCell& cell);

}  // namespace umbrameter

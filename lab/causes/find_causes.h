// SPDX-License-Identifier: Apache-2.0
#pragma once
// Draws a run again with one thing after another replaced, and measures what that does to its faults. Sees only pictures.

#include "lab/causes/replacement.h"
#include "metrics/causes/fault_causes.h"

#include <functional>

namespace umbrameter {

/// A picture of the run as `replacement` has it, under one of its lights.
using DrawReplaced = std::function<Image(const Replacement& replacement, const Light& light)>;

/// A run's picture with its truth and the classes of its faults [height][width].
struct JudgedPicture {
  const Image& picture;
  const Image& reference;
  std::span<const FaultClass> classes;
};

/// Tries everything that the run has. What `draw` throws for one is that one's not_tried (Error{cancelled} passes through).
FaultCauses find_causes(const SubstitutedRun& run, const JudgedPicture& judged,
                        std::span<const FaultClass> faults, const DrawReplaced& draw);

/// How many of its own pictures that would cost, about.
double draws_of_causes(const SubstitutedRun& run);

}  // namespace umbrameter

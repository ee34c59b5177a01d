// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene at a value of an axis, with its truth and what the truth itself is worth.

#include "results/stress/outcome.h"
#include "study/stress/tools.h"

#include <filesystem>
#include <string>

namespace umbrameter {

/// Techniques can be judged only if `is_usable`. `reference` is empty for a scene that was refused.
struct StressScene {
  StressCell truth;
  bool is_usable = false;
  Scene scene;
  Image reference;
};

/// Writes the point's files to `place`, loads them as any scene is loaded and renders both references of it: surfaces and
/// truth. The truth is held against the oracle, against itself, and against the surfaces.
StressScene make_stress_scene(const StressPoint& point, const std::filesystem::path& place,
                              const RenderRequest& request, const StressTools& tools, Progress& progress);

/// A cell that has no more than an outcome.
StressCell stress_failure(StressOutcome outcome, const std::string& how);

}  // namespace umbrameter

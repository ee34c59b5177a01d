// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes of the faults of a scene's runs: of which runs, whether that is worth its time, and their pictures.

#include "lab/scene_run.h"

#include <vector>

namespace umbrameter {

/// The runs that the plan wants causes of, known or not: with a fault, and with parameters to replace; the worst by RMSE first.
std::vector<TechniqueFrame*> runs_with_wanted_causes(const ValidationPlan& plan,
                                                     std::span<TechniqueFrame> runs);

/// Sets TechniqueResult::fault_causes of those that have none yet, one by one. With CausesWanted::automatic each as long as pictures drawn
/// for causes stay fewer than those of the scene itself: a count, so that it does not depend on the clock.
void find_run_causes(const SceneContext& context, const Image& reference, const SceneResult& scene,
                     std::span<TechniqueFrame> runs, const RunDone& run_done);

}  // namespace umbrameter

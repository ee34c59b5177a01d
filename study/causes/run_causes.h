// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes of the faults of a scene's runs: of which runs, whether that is worth its time, and their pictures.

#include "study/scene_run.h"

#include <vector>

namespace umbrameter {

/// The runs that the plan wants causes of and that have none yet: with a fault, and with parameters to replace; the worst by
/// RMSE first.
std::vector<TechniqueFrame*> runs_without_causes(const ValidationPlan& plan, std::span<TechniqueFrame> runs);

/// Sets TechniqueResult::fault_causes of these runs. `scene` tells what everything else of the scene cost.
void find_run_causes(const SceneContext& context, const Image& reference, const SceneResult& scene,
                     std::span<TechniqueFrame> runs);

}  // namespace umbrameter

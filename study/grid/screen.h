// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parameters that cannot be seen to matter in a scene: small pictures of a study's extreme values, compared bit by bit. A hint
// for whoever writes the study, no proof: nothing is left out because of it.

#include "study/grid/plan.h"

#include <span>
#include <string>
#include <vector>

namespace umbrameter {

inline constexpr int kScreenWidth_px = 96;
inline constexpr int kScreenHeight_px = 54;

struct IdleParameter {
  size_t scene = 0;  // index
  std::string technique;
  std::string parameter;
  size_t runs = 0;  // of the plan that differ from another one in this parameter alone
  double saved_s = 0.0;
};

/// For every scene and technique of the plan, each parameter that its runs give several values: those whose lowest and
/// highest value, the others as in the first run that has it, make the same picture. Runs that fail say nothing. Renders
/// two small pictures a scene, technique and parameter.
std::vector<IdleParameter> screen_parameters(const SweepPlan& plan, std::span<const StudyScene> scenes,
                                             std::span<const PlanStep> steps, Renderer& realtime,
                                             Progress& progress);

}  // namespace umbrameter

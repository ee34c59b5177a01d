// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parts of a plan that people look into.

#include "realtime/executor/plan.h"
#include "realtime/inspect.h"

#include <vector>

namespace umbrameter {

/// What a texture's layer and level or a buffer holds. Error{input} for one that the run does not have or that cannot be
/// read, or a layer or level it has not. What no pass has drawn into gets memory first.
Image read_part(const Technique& technique, Targets& targets, const ResourcePart& part);

/// Ids of a plan's passes, each once, in their order.
std::vector<std::string> drawn_passes(const Plan& plan);

/// The shaders of a plan's passes, each text once.
std::vector<FinalShader> final_shaders(const Plan& plan);

}  // namespace umbrameter

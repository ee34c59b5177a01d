// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a manifest declares and a run does not need. Not here: leaving it out (plan.cpp, targets.cpp).

#include "realtime/executor/plan.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Passes and textures whose conditions do not hold: "pass map_sloped", "texture first_layer (4.00 MiB)".
std::vector<std::string> left_out(const RunInputs& inputs, const Plan& plan);

}  // namespace umbrameter

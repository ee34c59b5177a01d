// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lengths that follow the scene's size, in world units: what a tuner searches and writes down.

#include "study/tune/tune.h"

#include <span>

namespace umbrameter {

/// Makes ranges, defaults, presets and the base of `plan` world units of the smallest of the scenes, so that one setting
/// is allowed in all. Error{input} for values outside their range there. Adds to `plan.notes` when the scenes differ.
void resolve_lengths(TunePlan& plan, std::span<const SceneJob> scenes);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The truth's blockers for shaders that look for some (realtime/shaders/lib/blocker_truth.glsl).

#include "core/image.h"
#include "realtime/executor/plan.h"

#include <string>

namespace umbrameter {

/// Texture unit of the sampler `blocker_truth`, beyond those that passes read.
inline constexpr GLuint kBlockerTruthUnit = 31;

/// The planes blocker_offset.x/y/z, GL's rows; Error{input} for a truth of another size or without them.
Texture upload_blocker_truth(const Image& truth, int width_px, int height_px);

/// Error{input} naming the technique unless a pass of `plan` reads the truth's blockers.
void require_blocker_search(const Plan& plan, const std::string& technique);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// assimp's animations at one moment.

#include "scenes/assimp/assimp_file.h"

#include <map>

namespace umbrameter {

/// What an animation makes of nodes, by name.
using AssimpPoses = std::map<std::string, glm::dmat4>;  // parent from node

/// At `at`; sets file.animation, file.morph_weights and file.warnings. Before its first key a channel holds that one, after its last
/// one that. Empty, as file.animation, for a file without animations. Error{input} as open_assimp().
AssimpPoses pose_assimp(AssimpFile& file, const AnimationTime& at);

/// A name for each animation: its own, or "animation 2".
std::vector<std::string> assimp_animation_names(const AssimpFile& file);

}  // namespace umbrameter

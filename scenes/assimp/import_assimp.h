// SPDX-License-Identifier: Apache-2.0
#pragma once
// An FBX file as a scene.

#include "scenes/imported_scene.h"

namespace umbrameter {

/// True for files whose cameras and lights are read: those that end in .fbx.
bool is_assimp_scene(const std::string& name);

/// Its cameras and lights, where they are at `at`; `scenes/imported_scene.h` says what becomes of them. FBX lights have no size:
/// properties of the node (in Blender: custom ones, exported with it) may give `radius`, `size` (two numbers: a rect), in metres, or
/// `angular_diameter_deg`. Ambient lights are left out and counted; area and volume lights, which assimp does not tell apart, are
/// areas. Error{input} as open_assimp() and load_assimp_mesh(), and for `at` of a file without animations.
FoundScene find_assimp_scene(const std::filesystem::path& path, const std::optional<AnimationTime>& at);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A glTF file as a scene.

#include "scenes/imported_scene.h"

namespace umbrameter {

/// Its perspective cameras and lights (KHR_lights_punctual), where they are at `at`; `scenes/imported_scene.h` says what becomes of
/// them. glTF lights have no size: "extras" of the node, else of the light, may give `radius` or `size` (of a rect: a spot with
/// it) or `angular_diameter_deg`. Error{input} as open_gltf() and load_gltf_mesh(), and for `at` of a file without animations.
FoundScene find_gltf_scene(const std::filesystem::path& path, const std::optional<AnimationTime>& at);

}  // namespace umbrameter

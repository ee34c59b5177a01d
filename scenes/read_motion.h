// SPDX-License-Identifier: Apache-2.0
#pragma once
// [motion] of a scene file.

#include "core/toml.h"
#include "scenes/scene.h"

namespace umbrameter {

/// Reads `table` (docs/scene-format.md) for a scene that has its lights and meshes. Error{input} for a motion that moves
/// nothing, an object that is no mesh of the scene's own triangles, and a step of a light that is a sun.
Motion read_motion(const TomlNode& table, const Scene& scene);

}  // namespace umbrameter

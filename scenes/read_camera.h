// SPDX-License-Identifier: Apache-2.0
#pragma once
// [camera] of a scene file.

#include "core/toml.h"
#include "scenes/scene.h"

namespace umbrameter {

/// Reads `table` (docs/scene-format.md); near_world stays 0 unless given. Error{input} when the camera stands
/// on its target, `up` is parallel to the view direction, or the field of view is not inside (0, 180)
/// degrees.
Camera read_camera(const TomlNode& table);

}  // namespace umbrameter

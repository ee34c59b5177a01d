// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cameras and lights as scene files have them (docs/scene-format.md); scenes/read_camera.h and scenes/read_light.h read them back.

#include "scenes/scene.h"

#include <string>

namespace umbrameter {

/// The keys of a [camera], one a line; `near` unless it is left to the loader.
std::string camera_keys(const Camera& camera);
/// The keys of a [[light]], one a line; `tangent` where it is not the one that follows from the direction.
std::string light_keys(const Light& light);

}  // namespace umbrameter

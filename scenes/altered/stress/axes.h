// SPDX-License-Identifier: Apache-2.0
#pragma once
// The axes that alter a scene, by family. Not here: those of techniques' parameters (study/stress/axes.h).

#include "scenes/altered/stress/axis.h"

#include <vector>

namespace umbrameter {

/// Where the scene lies and how large it is.
std::vector<StressAxis> placement_axes();
std::vector<StressAxis> light_axes();
std::vector<StressAxis> geometry_axes();
/// Meshes that are not as they should be.
std::vector<StressAxis> mesh_axes();
std::vector<StressAxis> camera_axes();

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A light cut into smaller ones, so that what is drawn from a light's centre is drawn from all over it.

#include "scenes/light.h"

#include <vector>

namespace umbrameter {

inline constexpr int kLightPartsPerSide = 4;

/// 16 lights of a sixteenth of the area. A rect's tile it exactly; those of a round light (sphere: of the disk facing
/// along direction_world) are disks around evenly spread points, which overlap and leave gaps.
std::vector<Light> light_parts(const Light& light);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The truth's mean way to what blocks a receiver, as planes of an image.

#include <array>

namespace umbrameter {

inline constexpr std::array<const char*, 3> kBlockerOffsetPlanes = {"blocker_offset.x", "blocker_offset.y",
                                                                    "blocker_offset.z"};

}  // namespace umbrameter

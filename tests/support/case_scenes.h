// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes as people have written them, whose faults once had a wrong name.

#include <string_view>

namespace umbrameter {

/// A wide filter at the board's contact with the floor is a penumbra that is too wide.
inline constexpr std::string_view kLeaningBoard = R"(title = "Board leaning over the floor"
[camera]
eye = [0, 4, 6]
at = [0, 0, 0]
fov_deg = 45
[[mesh]]
shape = "plane"
size = [12, 12]
[[mesh]]
shape = "box"
size = [0.6, 0.05, 4]
axis = [1, 0, 0]
rotate_deg = 30
translate = [0, 1.1, 0]
[[light]]
type = "disk"
center = [3, 6, 0]
at = [0, 0, 0]
radius = 0.5
)";

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lights that geometry swallows: a common mistake, and one that makes a picture black without an error.

#include "scenes/scene.h"

#include <string>
#include <vector>

namespace umbrameter {

/// One warning for each light (not suns) whose centre lies on a triangle (within 1e-6 of the scene's
/// diagonal), whose body is pierced by a part, or that is inside a part that the camera is outside of. Inside is decided by counting crossings along
/// three rays, by majority, so parts with holes may be misjudged; rooms, which hold camera and light alike,
/// are not reported.
std::vector<std::string> find_enclosed_lights(const Scene& scene);

}  // namespace umbrameter

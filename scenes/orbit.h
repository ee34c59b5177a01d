// SPDX-License-Identifier: Apache-2.0
#pragma once
// Cameras around what they look at.

#include "scenes/scene.h"

namespace umbrameter {

/// The camera turned around what it looks at, about its up direction.
Camera orbit(const Camera& camera, double angle_deg);

}  // namespace umbrameter

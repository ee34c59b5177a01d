// SPDX-License-Identifier: Apache-2.0
#pragma once
// How mouse and keys move a camera. Pure functions.

#include "scenes/scene.h"

namespace umbrameter {

/// The camera turned about its eye: yaw to the right, pitch up. It stays 2 degrees away from straight up and down.
Camera looked_around(Camera camera, double yaw_rad, double pitch_rad);

/// The camera turned about what it looks at, which stays in the middle.
Camera orbited(Camera camera, double yaw_rad, double pitch_rad);

/// Moved by `steps_world` along its right, its up and its view direction; the target moves with it.
Camera flown(Camera camera, const glm::dvec3& steps_world);

/// Its distance to the target times `factor`, which must be positive.
Camera dollied(Camera camera, double factor);

/// Part way, `share` in [0, 1], from one camera to the other.
Camera between(const Camera& from, const Camera& to, double share);

}  // namespace umbrameter

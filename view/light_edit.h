// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a light is placed and sized by hand. Pure functions.

#include "scenes/scene.h"

namespace umbrameter {

/// The light facing along `direction_world`, which need not be unit; it turns as little as it can.
Light facing(Light light, const glm::dvec3& direction_world);

/// The light where the camera is, facing what it looks at; of a sun the direction alone.
Light at_camera(Light light, const Camera& camera);

/// Its width, height, radius or angle times `factor`; a sun's angular diameter stays within 1e-6 and 90 degrees.
Light resized(Light light, double factor);

}  // namespace umbrameter

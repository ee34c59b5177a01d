// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a light is placed and sized by hand. Pure functions.

#include "scenes/scene.h"

namespace umbrameter {

/// The light facing along `direction_world`, which need not be unit; it turns as little as it can.
Light facing(Light light, const glm::dvec3& direction_world);

/// The light where the camera is, facing what it looks at; of a sun the direction alone.
Light at_camera(Light light, const Camera& camera);

/// Turned about what the camera looks at, as a drag in its picture turns things: `yaw_rad` about its up, `pitch_rad` about
/// its right. A sun turns where it is.
Light swung(Light light, const Camera& camera, double yaw_rad, double pitch_rad);

/// Its width, height, radius or angle times `factor`; a sun's angular diameter stays within 1e-6 and 90 degrees.
Light resized(Light light, double factor);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes that are not what they should be.

#include "scenes/scene.h"

#include <string_view>

namespace umbrameter {

/// Width and height, radius or angle of the light times `factor`.
Scene with_light_scaled(Scene scene, double factor);

/// The light moved sideways by `share` of its distance from what the camera looks at (sun: turned by as many radians).
Scene with_light_moved(Scene scene, double share);

/// The light turned by `angle_rad` about its tangent.
Scene with_light_turned(Scene scene, double angle_rad);

/// Error{internal} without a part of that name.
Scene without_part(Scene scene, std::string_view part);

/// Only the triangles that are wound away from the light, as culling leaves them; the camera's floor stays.
Scene without_faces_to_light(Scene scene, std::string_view floor_part);

}  // namespace umbrameter

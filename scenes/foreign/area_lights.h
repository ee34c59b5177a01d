// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lights from shapes that shine.

#include "scenes/light.h"
#include "scenes/primitives.h"

#include <optional>

namespace umbrameter {

/// Of two triangles that form a rectangle, to one part in 10,000; it shines to the side that their winding faces. Absent for
/// everything else.
std::optional<Light> rect_light(const Primitive& world);

/// Of the disk of radius 1 around the origin that faces +z. Where it becomes an ellipse: a disk of the same area; `is_exact` is
/// false then. Absent when it has no area.
std::optional<Light> disk_light(const glm::dmat4& world_from_disk, bool& is_exact);

/// Of the sphere of radius 1 around the origin. Where it becomes an ellipsoid: a sphere of the same volume, as above.
std::optional<Light> sphere_light(const glm::dmat4& world_from_sphere, bool& is_exact);

/// Shines to the other side.
void turn_around(Light& light);

}  // namespace umbrameter

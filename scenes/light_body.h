// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lights as bodies in space.

#include "scenes/scene.h"

namespace umbrameter {

/// Bounds of the light's body; empty for a sun, which has no place.
Bounds3 light_bounds(const Light& light);

/// Whether the triangle reaches into the light's body, by more than a thousandth of the light's size: into the ball of a
/// sphere, through the face of a rect or disk. A triangle in the plane of a flat light does not. False for a sun.
bool pierces(const Light& light, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Distance from `p` to the triangle.
double triangle_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace umbrameter

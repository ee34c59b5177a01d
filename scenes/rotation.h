// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rotations by degrees.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace umbrameter {

/// Right-handed, about the unit `axis`; exact at multiples of 90 degrees about a coordinate axis, so that boxes stay on round
/// numbers.
glm::dmat3 rotation(const glm::dvec3& axis, double angle_deg);

}  // namespace umbrameter

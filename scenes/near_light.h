// SPDX-License-Identifier: Apache-2.0
#pragma once
// Irradiance from lights that are near for their size, in closed form: there a grid of points misses the peak. The GLSL
// twin is realtime/shaders/gbuffer/near_light.glsl.

#include "scenes/light.h"

namespace umbrameter {

/// Whether `p_world` lies less than half a flat light's width from its plane, or within a radius of a sphere. Never for the
/// sun.
bool is_near_light(const Light& light, const glm::dvec3& p_world);

/// What unshadowed_irradiance() means, of a rectangle and a sphere exactly, of a disk as a polygon of 64 corners and the
/// same area. 0 behind a flat light and inside a sphere.
double near_irradiance(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world);

}  // namespace umbrameter

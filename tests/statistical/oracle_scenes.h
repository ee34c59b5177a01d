// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes whose visibility is known in closed form at every point of the floor y = 0, lights straight above.

#include "tests/support/procedural_scene.h"

namespace umbrameter {

inline constexpr double kLightHeight = 5.0;
inline constexpr double kOccluderHeight = 1.0;
/// A point of the occluder's height lies this fraction of the way from the floor to the light.
inline constexpr double kFraction = kOccluderHeight / kLightHeight;

/// Floor under `light`, seen by a camera below the occluder's height. No occluder yet; call finish_scene.
Scene floor_under(const Light& light, double seen_width);

/// Adds a sheet that covers x < 0 at the occluder's height.
void add_half_plane(Scene& scene);

/// Visibility at floor x under the half-plane: square light of width `size`, disk and sphere of `radius`,
/// sun.
double half_plane_square(double x, double size);
double half_plane_disk(double x, double radius);
double half_plane_sun(double x, double half_angle_rad);
double half_plane_sphere(const glm::dvec3& p_world, double radius);

/// Rectangular plate [-half.x, half.x] x [-half.y, half.y] under a rectangular light of `size`.
double plate_rect(const glm::dvec3& p_world, const glm::dvec2& half, const glm::dvec2& size);

/// Disk of `occluder_radius` on the axis of a disk light of `light_radius`.
double coaxial_disks(const glm::dvec3& p_world, double occluder_radius, double light_radius);

/// Irradiance at the origin, normal +y, from unit radiance of the rectangle [x0,x1] x [z0,z1] at height `y`.
double rectangle_irradiance(double x0, double x1, double z0, double z1, double y);

}  // namespace umbrameter

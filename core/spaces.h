// SPDX-License-Identifier: Apache-2.0
#pragma once
// Spaces and their conventions, written once (docs/conventions.md tells why).
//   matrices  read dst_from_src, column vectors
//   view      right-handed, camera looks along -z, y up
//   clip      GL with glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); depth is reversed: near 1, far 0
//   pixels    index (x, y), row 0 on top; the centre of a pixel is at +0.5
//   light     x = tangent, y = bitangent, z = distance along the light's direction, origin at the viewpoint

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace umbrameter {

glm::dmat4 view_from_world(const glm::dvec3& eye_world, const glm::dvec3& at_world,
                           const glm::dvec3& up_world);

/// Reversed-depth perspective projection without a far plane.
glm::dmat4 clip_from_view(double vertical_fov_rad, double aspect, double near_world);

/// Unit direction in view space through the continuous pixel position `p_px` (centre of pixel x,y =
/// x+.5,y+.5).
glm::dvec3 view_direction_of_pixel(const glm::dvec2& p_px, int width_px, int height_px,
                                   double vertical_fov_rad);

/// Continuous pixel position of a clip-space point.
glm::dvec2 pixel_of_clip(const glm::dvec4& p_clip, int width_px, int height_px);

/// Stored depth in [0,1] (near 1, far 0) of a distance z along the view axis, and back.
double perspective_depth(double z_world, double near_world, double far_world);
double perspective_distance(double depth_reversed, double near_world, double far_world);
double orthographic_depth(double z_world, double near_world, double far_world);
double orthographic_distance(double depth_reversed, double near_world, double far_world);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "core/spaces.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace umbrameter {

glm::dmat4 view_from_world(const glm::dvec3& eye_world, const glm::dvec3& at_world,
                           const glm::dvec3& up_world) {
  return glm::lookAtRH(eye_world, at_world, up_world);
}

glm::dmat4 clip_from_view(double vertical_fov_rad, double aspect, double near_world) {
  const double focal = 1.0 / std::tan(0.5 * vertical_fov_rad);
  glm::dmat4 clip(0.0);
  clip[0][0] = focal / aspect;
  clip[1][1] = focal;
  clip[2][3] = -1.0;        // w = distance along the view axis
  clip[3][2] = near_world;  // z / w = near / distance: 1 at the near plane, 0 at infinity
  return clip;
}

glm::dvec3 view_direction_of_pixel(const glm::dvec2& p_px, int width_px, int height_px,
                                   double vertical_fov_rad) {
  const double half_height = std::tan(0.5 * vertical_fov_rad);
  const double half_width = half_height * width_px / height_px;
  const double x_ndc = 2.0 * p_px.x / width_px - 1.0;
  const double y_ndc = 1.0 - 2.0 * p_px.y / height_px;
  return glm::normalize(glm::dvec3(x_ndc * half_width, y_ndc * half_height, -1.0));
}

glm::dvec2 pixel_of_clip(const glm::dvec4& p_clip, int width_px, int height_px) {
  const glm::dvec2 ndc = glm::dvec2(p_clip) / p_clip.w;
  return {(0.5 + 0.5 * ndc.x) * width_px, (0.5 - 0.5 * ndc.y) * height_px};
}

double perspective_depth(double z_world, double near_world, double far_world) {
  return near_world * (far_world - z_world) / (z_world * (far_world - near_world));
}

double perspective_distance(double depth_reversed, double near_world, double far_world) {
  return near_world * far_world / (near_world + depth_reversed * (far_world - near_world));
}

double orthographic_depth(double z_world, double near_world, double far_world) {
  return (far_world - z_world) / (far_world - near_world);
}

double orthographic_distance(double depth_reversed, double near_world, double far_world) {
  return far_world - depth_reversed * (far_world - near_world);
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene.h"

#include "core/spaces.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace umbrameter {

double Bounds3::diagonal() const {
  return empty() ? 0.0 : glm::length(max - min);
}

glm::dvec3 triangle_normal_world(const Scene& scene, uint32_t triangle) {
  const glm::uvec3 corners = scene.triangles[triangle];
  const glm::dvec3 a = scene.positions_world[corners.x];
  const glm::dvec3 b = scene.positions_world[corners.y];
  const glm::dvec3 c = scene.positions_world[corners.z];
  return glm::normalize(glm::cross(b - a, c - a));
}

glm::dmat4 view_from_world(const Camera& camera) {
  return view_from_world(camera.eye_world, camera.at_world, camera.up_world);
}

glm::dmat4 clip_from_world(const Camera& camera, int width_px, int height_px) {
  const double aspect = static_cast<double>(width_px) / height_px;
  return clip_from_view(glm::radians(camera.vertical_fov_deg), aspect, camera.near_world) *
         view_from_world(camera);
}

glm::dvec3 camera_ray_direction_world(const Camera& camera, const glm::dvec2& p_px, int width_px,
                                      int height_px) {
  const glm::dvec3 d_view =
      view_direction_of_pixel(p_px, width_px, height_px, glm::radians(camera.vertical_fov_deg));
  return glm::transpose(glm::dmat3(view_from_world(camera))) * d_view;
}

}  // namespace umbrameter

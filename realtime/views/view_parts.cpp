// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/view_parts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {

LightFrame frame_along(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& tangent) {
  const glm::dvec3 z = glm::normalize(direction);
  glm::dvec3 x = tangent - z * glm::dot(tangent, z);
  if (glm::dot(x, x) < 1e-12) {
    const glm::dvec3 other = std::abs(z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    x = other - z * glm::dot(other, z);
  }
  x = glm::normalize(x);
  return {origin, x, glm::cross(z, x), z};
}

glm::dmat4 light_from_world(const LightFrame& frame) {
  glm::dmat4 m(1.0);
  const glm::dvec3 rows[3] = {frame.x_world, frame.y_world, frame.z_world};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) m[column][row] = rows[row][column];
    m[3][row] = -glm::dot(rows[row], frame.origin_world);
  }
  return m;
}

glm::dmat4 clip_from_light(const LateralBounds& bounds, double near, double far, bool is_orthographic) {
  const glm::dvec2 scale = 2.0 / (bounds.max - bounds.min);
  const glm::dvec2 shift = -(bounds.max + bounds.min) / (bounds.max - bounds.min);
  glm::dmat4 m(0.0);
  m[0][0] = scale.x;
  m[1][1] = scale.y;
  if (is_orthographic) {
    m[3] = glm::dvec4(shift, far / (far - near), 1.0);
    m[2][2] = -1.0 / (far - near);
  } else {
    m[2] = glm::dvec4(shift, -near / (far - near), 1.0);
    m[3][2] = near * far / (far - near);
  }
  return m;
}

LightView make_view(const LightFrame& frame, const LateralBounds& bounds, double near, double far,
                    bool is_orthographic) {
  LightView view;
  view.light_from_world = glm::mat4(light_from_world(frame));
  view.clip_from_light = glm::mat4(clip_from_light(bounds, near, far, is_orthographic));
  view.lateral_bounds = glm::vec4(glm::vec2(bounds.min), glm::vec2(bounds.max));
  view.near_world = static_cast<float>(near);
  view.far_world = static_cast<float>(far);
  view.is_orthographic = is_orthographic;
  return view;
}

LateralBounds grown(const LateralBounds& bounds, const glm::dvec2& margin) {
  return {bounds.min - margin, bounds.max + margin, bounds.near, bounds.far};
}

LateralBounds with_rim(const LateralBounds& bounds, double scale) {
  const glm::dvec2 missing = glm::max(kMinimumExtent * scale - (bounds.max - bounds.min), 0.0);
  return grown(bounds, 0.5 * missing + kRimShare * (bounds.max - bounds.min + missing));
}

ReceiverTile scene_box(const Scene& scene) {
  return {glm::vec3(scene.bounds_world.min), glm::vec3(scene.bounds_world.max)};
}

LightView fit_scene_range(const Scene& scene, const LightFrame& frame, const LateralBounds& lateral,
                          bool is_orthographic) {
  const glm::dmat4 from_world = light_from_world(frame);
  const ReceiverTile box = scene_box(scene);
  const LateralBounds all =
      is_orthographic ? bound_orthographic(from_world, {&box, 1}) : bound_perspective(from_world, {&box, 1});
  const double scale = is_orthographic ? std::max(scene.bounds_world.diagonal(), 1e-30) : all.far;
  const double far = all.far + kMinimumExtent * scale;
  const double near =
      is_orthographic ? all.near - kMinimumExtent * scale : std::max(all.near, kNearShare * far);
  return make_view(frame, lateral, near, far, is_orthographic);
}

LightFrame sun_frame(const Scene& scene, const glm::dvec3& direction, const glm::dvec3& tangent) {
  const glm::dvec3 middle = 0.5 * (scene.bounds_world.min + scene.bounds_world.max);
  LightFrame frame = frame_along(middle, direction, tangent);
  const ReceiverTile all = scene_box(scene);
  frame.origin_world += frame.z_world * bound_orthographic(light_from_world(frame), {&all, 1}).near;
  return frame;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Views of all that lies around a light: the faces of a cube, two paraboloids.
#include "realtime/views/nearest_caster.h"
#include "realtime/views/view_parts.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr int kFaces = 6;

/// A right angle.
const LateralBounds kFaceBounds{glm::dvec2(-1.0), glm::dvec2(1.0), 0.0, 0.0};

/// s, t and major axis of a cube map's faces (OpenGL 4.5 core, table 8.19). Mirrored, so not frame_along().
LightFrame frame_of_face(const glm::dvec3& center_world, int face) {
  static const std::array<std::array<glm::dvec3, 3>, kFaces> axes = {{
      {glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0)},
      {glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0), glm::dvec3(-1, 0, 0)},
      {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0)},
      {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0)},
      {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)},
      {glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1)},
  }};
  const auto& [x, y, z] = axes.at(static_cast<size_t>(face));
  return {center_world, x, y, z};
}

}  // namespace

DistanceRange cube_range(const Scene& scene) {
  const glm::dvec3& center = scene.light().center_world;
  const glm::dvec3 reach =
      glm::max(glm::abs(scene.bounds_world.min - center), glm::abs(scene.bounds_world.max - center));
  const double far = std::max({reach.x, reach.y, reach.z}) * (1.0 + kMinimumExtent);
  const double floor = kNearShare * far;
  double near = far;
  for (int face = 0; face < kFaces; ++face) {
    const glm::dmat4 from_world = light_from_world(frame_of_face(center, face));
    near = nearest_caster_perspective(scene, from_world, kFaceBounds, floor, near);
  }
  return {near * (1.0 - kNearShare), far};
}

LightView fit_half_view(const Scene& scene, int half, const DistanceRange& range) {
  const Light& light = scene.light();
  const LightFrame own = frame_along(light.center_world, light.direction_world, light.tangent_world);
  const double side = half == 0 ? 1.0 : -1.0;  // half a turn about x
  const LightFrame frame{own.origin_world, own.x_world, side * own.y_world, side * own.z_world};
  // Along directions things are no nearer than along the axis of their face, and at most as far as that face's corner.
  LightView view = make_view(frame, kFaceBounds, range.near_world, std::sqrt(3.0) * range.far_world, false);
  view.is_paraboloid = true;
  return view;
}

LightView fit_face_view(const Scene& scene, int face, const DistanceRange& range) {
  const LightFrame frame = frame_of_face(scene.light().center_world, face);
  return make_view(frame, kFaceBounds, range.near_world, range.far_world, false);
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What light views of every kind are made of. Internal to views/.

#include "realtime/views/lateral_bounds.h"
#include "realtime/views/light_view.h"

namespace umbrameter {

/// Share of the extent added on each side, so that receivers at the rim stay inside after rounding and small
/// filters find casters there.
inline constexpr double kRimShare = 0.01;
/// Smallest extent relative to the distance scale: a single point still gets a map.
inline constexpr double kMinimumExtent = 1e-3;
/// Nearest usable distance of a perspective view, relative to its farthest receiver.
inline constexpr double kNearShare = 1e-4;

struct LightFrame {
  glm::dvec3 origin_world;
  glm::dvec3 x_world, y_world, z_world;
};

/// A frame looking along `direction`, its x axis as close to `tangent` as it gets.
LightFrame frame_along(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& tangent);
/// Moves the origin of a sun's frame to the plane through the scene's nearest caster, laterally to its middle.
LightFrame sun_frame(const Scene& scene, const glm::dvec3& direction, const glm::dvec3& tangent);
glm::dmat4 light_from_world(const LightFrame& frame);

/// Reversed depth, zero to one: perspective n (f - z) / (z (f - n)), orthographic (f - z) / (f - n).
glm::dmat4 clip_from_light(const LateralBounds& bounds, double near, double far, bool is_orthographic);
LightView make_view(const LightFrame& frame, const LateralBounds& bounds, double near, double far,
                    bool is_orthographic);
/// Lateral bounds as they are, at the scene's range of distances.
LightView fit_scene_range(const Scene& scene, const LightFrame& frame, const LateralBounds& lateral,
                          bool is_orthographic);

LateralBounds grown(const LateralBounds& bounds, const glm::dvec2& margin);
/// At least kMinimumExtent of `scale` wide, and a rim more.
LateralBounds with_rim(const LateralBounds& bounds, double scale);
ReceiverTile scene_box(const Scene& scene);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// A sun's view of a slice of the camera's frustum (Engel 2006, Zhang et al. 2006; the sphere: Valient 2012).
#include "realtime/views/camera_slice.h"
#include "realtime/views/nearest_caster.h"
#include "realtime/views/view_parts.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// A slice's corners within the scene's box.
LateralBounds corner_bounds(const Scene& scene, const glm::dmat4& from_world, const glm::ivec2& screen_px,
                            const CameraSlice& slice, const LateralBounds& all) {
  std::vector<ReceiverTile> points;
  for (const glm::dvec3& corner : corners_world(scene.camera, screen_px, slice))
    points.push_back({glm::vec3(corner), glm::vec3(corner)});
  LateralBounds bounds = bound_orthographic(from_world, points);
  bounds.min = glm::clamp(bounds.min, all.min, all.max);
  bounds.max = glm::clamp(bounds.max, all.min, all.max);
  bounds.far = std::clamp(bounds.far, all.near, all.far);
  return bounds;
}

/// The square around the slice's bounding sphere: the same size from frame to frame.
LateralBounds sphere_bounds(const Scene& scene, const glm::dmat4& from_world, const glm::ivec2& screen_px,
                            const CameraSlice& slice, const LateralBounds& all) {
  const Sphere sphere = sphere_around(scene.camera, screen_px, slice);
  const glm::dvec3 middle(from_world * glm::dvec4(sphere.center_world, 1.0));
  return {glm::dvec2(middle) - sphere.radius_world, glm::dvec2(middle) + sphere.radius_world, all.near,
          std::clamp(middle.z + sphere.radius_world, all.near, all.far)};
}

/// What the slice's map must show, before penumbrae reach out of it.
LateralBounds shown_bounds(const Scene& scene, const glm::dmat4& from_world, const glm::ivec2& screen_px,
                           std::span<const ReceiverTile> covered, LightFit fit, const CameraSlice& slice) {
  if (fit == LightFit::visible && !covered.empty()) return bound_orthographic(from_world, covered);
  const ReceiverTile box = scene_box(scene);
  const LateralBounds all = bound_orthographic(from_world, {&box, 1});
  return fit == LightFit::sphere ? sphere_bounds(scene, from_world, screen_px, slice, all)
                                 : corner_bounds(scene, from_world, screen_px, slice, all);
}

LightView fit_bounds(const Scene& scene, const LightFrame& frame, const LateralBounds& shown, LightFit fit,
                     double extent) {
  if (fit == LightFit::frustum) return fit_scene_range(scene, frame, with_rim(shown, extent), true);
  // A blocker of a receiver at distance z lies within (z - z_blocker) tan(half angle) of it.
  const glm::dmat4 from_world = light_from_world(frame);
  const double scale = std::max(scene.bounds_world.diagonal(), 1e-30);
  const double far = shown.far + kMinimumExtent * scale;
  const double tan_half_angle = std::tan(scene.light().half_angle_rad);
  const LateralBounds widest = grown(shown, glm::dvec2(far * tan_half_angle));
  const double reach = (far - nearest_caster_orthographic(scene, from_world, widest, far)) * tan_half_angle;
  const LateralBounds bounds = with_rim(grown(shown, glm::dvec2(reach)), extent);
  const double near = nearest_caster_orthographic(scene, from_world, bounds, far);
  return make_view(frame, bounds, near - 1e-6 * scale, far, true);
}

}  // namespace

bool follows_slice(LightFit fit) {
  switch (fit) {
    case LightFit::frustum:
    case LightFit::full:
    case LightFit::visible:
    case LightFit::sphere:
      return true;
    case LightFit::none:
    case LightFit::scene:
      return false;
  }
  return false;
}

LightView fit_slice_view(const Scene& scene, const glm::ivec2& screen_px,
                         std::span<const ReceiverTile> covered, LightFit fit, const CameraSlice& slice) {
  const Light& light = scene.light();
  const LightFrame frame = sun_frame(scene, light.direction_world, light.tangent_world);
  const LateralBounds shown = shown_bounds(scene, light_from_world(frame), screen_px, covered, fit, slice);
  // A slice is as wide as it is far: the first of a long view must not be blown up to a share of the scene.
  const double extent = std::min(scene.bounds_world.diagonal(), slice.far_world);
  LightView view = fit_bounds(scene, frame, shown, fit, extent);
  view.slice = slice;
  view.camera_axis = camera_axis(scene.camera);
  return view;
}

}  // namespace umbrameter

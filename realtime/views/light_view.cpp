// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/light_view.h"

#include "realtime/views/nearest_caster.h"
#include "realtime/views/view_parts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

LightFrame frame_of_light(const Light& light, const glm::dvec3& origin) {
  return {origin, light.tangent_world, light.bitangent_world, light.direction_world};
}

LateralBounds limited(LateralBounds bounds) {
  bounds.min = glm::clamp(bounds.min, -kTanLimit, kTanLimit);
  bounds.max = glm::clamp(bounds.max, -kTanLimit, kTanLimit);
  return bounds;
}

/// The box of the scene's bounding sphere.
ReceiverTile sphere_box(const Scene& scene) {
  const glm::dvec3 middle = 0.5 * (scene.bounds_world.min + scene.bounds_world.max);
  const double radius = 0.5 * scene.bounds_world.diagonal();
  return {glm::vec3(middle - radius), glm::vec3(middle + radius)};
}

std::vector<ReceiverTile> tiles_to_cover(const Scene& scene, std::span<const ReceiverTile> covered,
                                         LightFit fit) {
  if (fit == LightFit::none) return {sphere_box(scene)};
  if (fit == LightFit::scene || covered.empty()) return {scene_box(scene)};
  return {covered.begin(), covered.end()};
}

/// Whether the map is fitted laterally only, as simple engines do.
bool keeps_scene_range(LightFit fit) {
  return fit == LightFit::none || fit == LightFit::frustum;
}

/// Bounds of everything in front of the light; a unit square one unit ahead when nothing is.
LateralBounds perspective_bounds(const glm::dmat4& from_world, std::span<const ReceiverTile> tiles) {
  const LateralBounds bounds = bound_perspective(from_world, tiles);
  if (bounds.empty()) return {glm::dvec2(-0.5), glm::dvec2(0.5), 0.5, 1.0};
  return limited(with_rim(bounds, 1.0));
}

glm::dvec2 light_half_extent(const Light& light) {
  return light.type == LightType::rect ? 0.5 * light.size_world : glm::dvec2(light.radius_world);
}

LightView fit_perspective_center(const Scene& scene, const LightFrame& frame,
                                 std::span<const ReceiverTile> tiles, LightFit fit) {
  const glm::dmat4 from_world = light_from_world(frame);
  const LateralBounds receivers = perspective_bounds(from_world, tiles);
  if (keeps_scene_range(fit)) return fit_scene_range(scene, frame, receivers, false);
  const double far = receivers.far * (1.0 + kMinimumExtent);
  const double floor = kNearShare * far;

  // Blockers of a receiver at distance z lie within h (1/z_blocker - 1/z) of it, h the light's half extent.
  const glm::dvec2 limit = 0.5 * (receivers.max - receivers.min);
  const double widest_near =
      nearest_caster_perspective(scene, from_world, limited(grown(receivers, limit)), floor, far);
  const glm::dvec2 margin = light_half_extent(scene.light()) * (1.0 / widest_near - 1.0 / far);
  const LateralBounds bounds = limited(grown(receivers, glm::min(margin, limit)));

  const double near = nearest_caster_perspective(scene, from_world, bounds, floor, far);
  return make_view(frame, bounds, near * (1.0 - kNearShare), far, false);
}

LightView fit_sun(const Scene& scene, std::span<const ReceiverTile> tiles, const LightFrame& frame,
                  double tan_half_angle, LightFit fit) {
  const glm::dmat4 from_world = light_from_world(frame);
  const double scale = std::max(scene.bounds_world.diagonal(), 1e-30);
  const LateralBounds receivers = with_rim(bound_orthographic(from_world, tiles), scale);
  if (keeps_scene_range(fit)) return fit_scene_range(scene, frame, receivers, true);
  const double far = receivers.far + kMinimumExtent * scale;
  if (tan_half_angle <= 0.0) return make_view(frame, receivers, -kMinimumExtent * scale, far, true);

  const LateralBounds bounds = grown(receivers, glm::dvec2(far * tan_half_angle));
  const double near = nearest_caster_orthographic(scene, from_world, bounds, far);
  return make_view(frame, bounds, near - 1e-6 * scale, far, true);
}

/// Unit directions from the light to the middles of the tiles it does not sit in.
std::vector<glm::dvec3> directions_to(std::span<const ReceiverTile> tiles, const glm::dvec3& center_world) {
  std::vector<glm::dvec3> directions;
  for (const ReceiverTile& tile : tiles) {
    const glm::dvec3 offset = 0.5 * (glm::dvec3(tile.min_world) + glm::dvec3(tile.max_world)) - center_world;
    if (glm::length(offset) > 0.0) directions.push_back(glm::normalize(offset));
  }
  return directions;
}

const glm::dvec3& farthest_from(const glm::dvec3& axis, const std::vector<glm::dvec3>& directions) {
  return *std::ranges::min_element(directions, {}, [&](const glm::dvec3& d) { return glm::dot(axis, d); });
}

/// Axis of about the narrowest cone around the directions (Badoiu and Clarkson 2003, on the unit sphere);
/// their mean, which favours what fills the picture, when one map cannot hold that cone.
glm::dvec3 axis_towards(const std::vector<glm::dvec3>& directions, const glm::dvec3& fallback) {
  if (directions.empty()) return fallback;
  constexpr int kSteps = 100;
  constexpr double kCosWidest = 0.2588190451025207;  // cos(75 deg)
  glm::dvec3 axis = directions.front();
  for (int i = 0; i < kSteps; ++i) axis += (farthest_from(axis, directions) - axis) / (i + 2.0);
  if (glm::length(axis) > 0.0 &&
      glm::dot(glm::normalize(axis), farthest_from(axis, directions)) > kCosWidest) {
    return glm::normalize(axis);
  }
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& direction : directions) sum += direction;
  return glm::length(sum) > 0.0 ? glm::normalize(sum) : fallback;
}

LightView with_bounds(const LightView& view, const LateralBounds& bounds) {
  LightView result = view;
  result.clip_from_light =
      glm::mat4(clip_from_light(bounds, view.near_world, view.far_world, view.is_orthographic));
  result.lateral_bounds = glm::vec4(glm::vec2(bounds.min), glm::vec2(bounds.max));
  return result;
}

}  // namespace

LightView fit_center_view(const Scene& scene, std::span<const ReceiverTile> covered, LightFit fit) {
  const Light& light = scene.light();
  const std::vector<ReceiverTile> tiles = tiles_to_cover(scene, covered, fit);
  if (light.type == LightType::sun) {
    const LightFrame frame = sun_frame(scene, light.direction_world, light.tangent_world);
    return fit_sun(scene, tiles, frame, std::tan(light.half_angle_rad), fit);
  }
  if (light.type == LightType::sphere) {
    const glm::dvec3 axis = axis_towards(directions_to(tiles, light.center_world), light.direction_world);
    return fit_perspective_center(scene, frame_along(light.center_world, axis, light.tangent_world), tiles,
                                  fit);
  }
  return fit_perspective_center(scene, frame_of_light(light, light.center_world), tiles, fit);
}

LightView fit_sample_view(const Scene& scene, std::span<const ReceiverTile> covered, LightFit fit,
                          const glm::dvec2& light_uv) {
  const Light& light = scene.light();
  const std::vector<ReceiverTile> tiles = tiles_to_cover(scene, covered, fit);
  const glm::dvec3 point = light_point(light, light_uv);
  if (light.type == LightType::sun) {
    return fit_sun(scene, tiles, sun_frame(scene, -point, light.tangent_world), 0.0, fit);
  }
  // Casters in front of the near plane still cast: scene passes clamp depth. So the box is enough here, and a
  // loop over thousands of samples stays cheap.
  const LightFrame frame = frame_of_light(light, point);
  const LateralBounds bounds = perspective_bounds(light_from_world(frame), tiles);
  const double far = bounds.far * (1.0 + kMinimumExtent);
  return make_view(frame, bounds, std::max(1e-2 * bounds.near, kNearShare * far), far, false);
}

std::span<const std::string> light_fits() {
  static const std::array<std::string, 6> fits = {"none", "frustum", "scene", "full", "visible", "sphere"};
  return fits;
}

LightFit find_light_fit(std::string_view name) {
  const auto found = std::ranges::find(light_fits(), name);
  UMBRAMETER_ASSERT(found != light_fits().end(), "fit {}", name);
  return static_cast<LightFit>(found - light_fits().begin());
}

LightView snapped(const LightView& view, int texels_a_side) {
  constexpr double kStepsPerOctave = 4.0;
  const glm::dvec4 old(view.lateral_bounds);
  LateralBounds bounds{{old.x, old.y}, {old.z, old.w}, view.near_world, view.far_world};
  const glm::dvec2 extent = bounds.max - bounds.min;
  for (int axis = 0; axis < 2; ++axis) {
    // One more texel than needed: the corner moves down by up to one.
    const double least = extent[axis] * texels_a_side / std::max(texels_a_side - 1, 1);
    const double width = std::exp2(std::ceil(std::log2(least) * kStepsPerOctave) / kStepsPerOctave);
    const double texel = width / texels_a_side;
    bounds.min[axis] = std::floor(bounds.min[axis] / texel) * texel;
    bounds.max[axis] = bounds.min[axis] + width;
  }
  return with_bounds(view, bounds);
}

LightView moved_aside(const LightView& view, const glm::dvec2& offset_texels, int texels_a_side) {
  const glm::dvec4 old(view.lateral_bounds);
  LateralBounds bounds{{old.x, old.y}, {old.z, old.w}, view.near_world, view.far_world};
  const glm::dvec2 way = offset_texels * (bounds.max - bounds.min) / static_cast<double>(texels_a_side);
  bounds.min += way;
  bounds.max += way;
  return with_bounds(view, bounds);
}

glm::dvec4 camera_axis(const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(camera.at_world - camera.eye_world);
  return {forward, -glm::dot(forward, camera.eye_world)};
}

bool covers(const LightView& view, const glm::dvec3& p_world) {
  const double along_axis = glm::dot(view.camera_axis, glm::dvec4(p_world, 1.0));
  if (view.slice && (along_axis < view.slice->near_world || along_axis > view.slice->far_world)) return false;
  if (view.is_paraboloid) return (glm::dmat4(view.light_from_world) * glm::dvec4(p_world, 1.0)).z >= 0.0;
  const glm::dvec3 p = lateral_and_distance(view, p_world);
  if (!view.is_orthographic && p.z <= 0.0) return false;
  const glm::dvec4 bounds(view.lateral_bounds);
  return p.x >= bounds.x && p.y >= bounds.y && p.x <= bounds.z && p.y <= bounds.w;
}

glm::dvec3 lateral_and_distance(const LightView& view, const glm::dvec3& p_world) {
  const glm::dvec3 p_light(glm::dmat4(view.light_from_world) * glm::dvec4(p_world, 1.0));
  if (view.is_orthographic) return p_light;
  if (view.is_paraboloid) {
    const double distance = glm::length(p_light);
    return {p_light.x / (distance + p_light.z), p_light.y / (distance + p_light.z), distance};
  }
  return {p_light.x / p_light.z, p_light.y / p_light.z, p_light.z};
}

}  // namespace umbrameter

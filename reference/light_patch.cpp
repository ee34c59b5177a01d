// SPDX-License-Identifier: Apache-2.0
#include "reference/light_patch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr double kUnitRoundoff = 0x1p-24;  // of float

/// The plane the patch lies in: through `to_center`, at right angles to `axis`.
struct PatchPlane {
  glm::dvec3 to_center;
  glm::dvec3 axis;  // unit
  glm::dvec3 per_a;
  glm::dvec3 per_b;
};

/// Coordinate 1 is twice as far from the centre as uv = 3/4, for the square and for the disk alike.
template <class PointAt>
PatchPlane plane_through(const glm::dvec3& to_center, const glm::dvec3& axis, const PointAt& point_at) {
  const glm::dvec3 middle = point_at(glm::dvec2(0.5, 0.5));
  return {to_center, axis, 2.0 * (point_at(glm::dvec2(0.75, 0.5)) - middle),
          2.0 * (point_at(glm::dvec2(0.5, 0.75)) - middle)};
}

PatchPlane find_plane(const Light& light, const glm::dvec3& p_world, const LightSample& middle) {
  const glm::dvec3& way = middle.to_light_world;
  if (light.type == LightType::rect || light.type == LightType::disk) {
    return plane_through(way * middle.distance_world, light.direction_world,
                         [&](const glm::dvec2& uv) { return light_point(light, uv); });
  }
  // Samples are directions; their points are where these meet the plane.
  const double distance = light.type == LightType::sphere ? glm::distance(light.center_world, p_world) : 1.0;
  return plane_through(way * distance, way, [&](const glm::dvec2& uv) {
    const glm::dvec3 direction = sample_light(light, p_world, way, uv).to_light_world;
    return direction * (distance / glm::dot(direction, way));
  });
}

PatchForm form_of(double center, double per_a, double per_b) {
  return {static_cast<float>(center), static_cast<float>(per_a), static_cast<float>(per_b)};
}

PatchForm form_of(const glm::dvec3& n, const PatchPlane& plane) {
  return form_of(glm::dot(n, plane.to_center), glm::dot(n, plane.per_a), glm::dot(n, plane.per_b));
}

void set_directions(LightPatch& patch, const glm::dvec3& center, const PatchPlane& plane) {
  patch.direction_x = form_of(center.x, plane.per_a.x, plane.per_b.x);
  patch.direction_y = form_of(center.y, plane.per_a.y, plane.per_b.y);
  patch.direction_z = form_of(center.z, plane.per_a.z, plane.per_b.z);
}

/// How far the form strays from its centre, rounded up.
float spread(const PatchForm& form, bool round) {
  const float exact = round ? std::sqrt(form.per_a * form.per_a + form.per_b * form.per_b)
                            : std::abs(form.per_a) + std::abs(form.per_b);
  return exact * 1.00001f;
}

float greatest(const PatchForm& form, bool round) {
  return form.center + spread(form, round);
}

}  // namespace

glm::dvec3 to_light_center(const Light& light, const glm::dvec3& p_world) {
  if (light.type == LightType::sun) return -light.direction_world;
  const glm::dvec3 way = light.center_world - p_world;
  const double length = glm::length(way);
  return length > 0.0 ? way / length : glm::dvec3(0.0);
}

LightPatch make_light_patch(const Light& light, const Receiver& receiver, double scene_extent_world) {
  LightPatch patch;
  const glm::dvec3& p = receiver.p_world;
  const LightSample middle = sample_light(light, p, to_light_center(light, p), {0.5, 0.5});
  patch.dark = !(middle.irradiance_weight > 0.0);
  if (patch.dark) return patch;
  const PatchPlane plane = find_plane(light, p, middle);

  patch.round = light.type != LightType::rect;
  patch.at_infinity = light.type == LightType::sun;
  patch.above_surface = form_of(receiver.n_geometric_world, plane);
  patch.shading = form_of(receiver.n_shading_world, plane);
  const double length = glm::length(plane.to_center);
  patch.strength =
      static_cast<float>(middle.irradiance_weight * (patch.at_infinity ? 1.0 : length * length * length));
  if (patch.at_infinity) {
    set_directions(patch, plane.to_center, plane);
    return patch;
  }
  set_directions(patch, plane.to_center + (p - glm::dvec3(receiver.ray_origin_world)), plane);
  if (light.type == LightType::sphere) patch.sphere_radius_world = static_cast<float>(light.radius_world);
  // A surface in the light's own plane must not cut the rays off: stop as far before it as Embree may err.
  const double height = std::abs(glm::dot(plane.to_center, plane.axis));
  const double error_world = 8.0 * kUnitRoundoff * (scene_extent_world + length);
  patch.end_fraction = static_cast<float>(1.0 - std::min(0.5, error_world / height));
  return patch;
}

bool is_below_horizon(const LightPatch& patch) {
  return patch.dark || greatest(patch.above_surface, patch.round) <= 0.0f;
}

bool is_unlit(const LightPatch& patch) {
  return patch.dark || greatest(patch.shading, patch.round) <= 0.0f;
}

bool straddles_horizon(const LightPatch& patch) {
  return !is_unlit(patch) && patch.shading.center <= spread(patch.shading, patch.round);
}

}  // namespace umbrameter

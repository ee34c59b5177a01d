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
  bool along_ray;   // sphere and sun: samples are directions, their points are where these meet the plane
};

glm::dvec3 to_patch_point(const PatchPlane& plane, const LightSample& sample) {
  if (!plane.along_ray) return sample.to_light_world * sample.distance_world;
  return sample.to_light_world *
         (glm::dot(plane.to_center, plane.axis) / glm::dot(sample.to_light_world, plane.axis));
}

PatchPlane find_plane(const Light& light, const glm::dvec3& p_world, const LightSample& middle) {
  switch (light.type) {
    case LightType::rect:
    case LightType::disk:
      return {middle.to_light_world * middle.distance_world, light.direction_world, false};
    case LightType::sphere:
      return {middle.to_light_world * glm::distance(light.center_world, p_world), middle.to_light_world,
              true};
    case LightType::sun:
      break;
  }
  return {middle.to_light_world, middle.to_light_world, true};
}

PatchForm form_of(const glm::dvec3& n, const glm::dvec3& center, const glm::dvec3& per_a,
                  const glm::dvec3& per_b) {
  return {static_cast<float>(glm::dot(n, center)), static_cast<float>(glm::dot(n, per_a)),
          static_cast<float>(glm::dot(n, per_b))};
}

void set_directions(LightPatch& patch, const glm::dvec3& center, const glm::dvec3& per_a,
                    const glm::dvec3& per_b) {
  patch.direction_x = form_of({1, 0, 0}, center, per_a, per_b);
  patch.direction_y = form_of({0, 1, 0}, center, per_a, per_b);
  patch.direction_z = form_of({0, 0, 1}, center, per_a, per_b);
}

float greatest(const PatchForm& form, bool round) {
  const float spread =
      round ? std::hypot(form.per_a, form.per_b) : std::abs(form.per_a) + std::abs(form.per_b);
  return form.center + spread * 1.00001f;
}

}  // namespace

LightPatch make_light_patch(const Light& light, const Receiver& receiver, double scene_extent_world) {
  LightPatch patch;
  const glm::dvec3& p = receiver.p_world;
  const LightSample probe = sample_light(light, p, receiver.n_geometric_world, {0.5, 0.5});
  const LightSample middle = sample_light(light, p, probe.to_light_world, {0.5, 0.5});
  patch.dark = !(middle.irradiance_weight > 0.0);
  if (patch.dark) return patch;

  // Coordinate 1 is twice as far from the centre as uv = 3/4, for the square and for the disk alike.
  const PatchPlane plane = find_plane(light, p, middle);
  const auto edge = [&](const glm::dvec2& uv) {
    return 2.0 * (to_patch_point(plane, sample_light(light, p, middle.to_light_world, uv)) - plane.to_center);
  };
  const glm::dvec3 per_a = edge({0.75, 0.5});
  const glm::dvec3 per_b = edge({0.5, 0.75});

  patch.round = light.type != LightType::rect;
  patch.at_infinity = light.type == LightType::sun;
  patch.above_surface = form_of(receiver.n_geometric_world, plane.to_center, per_a, per_b);
  patch.shading = form_of(receiver.n_shading_world, plane.to_center, per_a, per_b);
  const double length = glm::length(plane.to_center);
  patch.strength =
      static_cast<float>(middle.irradiance_weight * (patch.at_infinity ? 1.0 : length * length * length));
  if (patch.at_infinity) {
    set_directions(patch, plane.to_center, per_a, per_b);
    return patch;
  }
  set_directions(patch, plane.to_center + (p - glm::dvec3(receiver.ray_origin_world)), per_a, per_b);
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

}  // namespace umbrameter

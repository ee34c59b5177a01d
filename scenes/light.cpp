// SPDX-License-Identifier: Apache-2.0
#include "scenes/light.h"

#include "core/sampling/patterns.h"
#include "scenes/near_light.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbrameter {

namespace {

/// A point of the unit disk for `uv`; double in, float pattern: 24 bits place a sample finely enough.
glm::dvec2 disk_point(const glm::dvec2& uv) {
  return concentric_disk(glm::vec2(uv));
}

/// A unit vector at right angles to unit `n` (Duff et al. 2017, made branch-free by the sign of z).
glm::dvec3 any_perpendicular(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  return {1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

/// A point of a flat one-sided light: cosine at the light x 1/distance^2 x area makes irradiance per sample.
LightSample sample_flat(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world,
                        const glm::dvec3& p_light_world, double area) {
  const glm::dvec3 offset = p_light_world - p_world;
  const double distance = glm::length(offset);
  LightSample sample;
  sample.distance_world = distance;
  if (distance == 0.0) return sample;
  sample.to_light_world = offset / distance;
  const double cos_receiver = std::max(0.0, glm::dot(n_world, sample.to_light_world));
  const double cos_light = std::max(0.0, -glm::dot(light.direction_world, sample.to_light_world));
  sample.irradiance_weight = area * cos_receiver * cos_light / (distance * distance);
  return sample;
}

LightSample sample_sphere(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world,
                          const glm::dvec2& uv) {
  const glm::dvec3 to_center = light.center_world - p_world;
  const double distance = glm::length(to_center);
  LightSample sample;
  if (distance <= light.radius_world) return sample;
  const double sin_half_angle = light.radius_world / distance;
  const double tan_half_angle = sin_half_angle / std::sqrt(1.0 - sin_half_angle * sin_half_angle);
  const glm::dvec3 axis = to_center / distance;
  const glm::dvec3 tangent = any_perpendicular(axis);
  const glm::dvec2 disk = tan_half_angle * disk_point(uv);
  const glm::dvec3 direction = axis + disk.x * tangent + disk.y * glm::cross(axis, tangent);
  const double length = glm::length(direction);
  sample.to_light_world = direction / length;
  // Near intersection with the sphere; clamped because a ray along the cone grazes it within rounding.
  const double along = glm::dot(sample.to_light_world, to_center);
  const double off_axis2 = distance * distance - along * along;
  sample.distance_world =
      along - std::sqrt(std::max(0.0, light.radius_world * light.radius_world - off_axis2));
  // Solid angle of a tan-plane element is dA / length^3; the disk's area is pi tan^2.
  const double solid_angle = std::numbers::pi * tan_half_angle * tan_half_angle / (length * length * length);
  sample.irradiance_weight = solid_angle * std::max(0.0, glm::dot(n_world, sample.to_light_world));
  return sample;
}

}  // namespace

std::string_view to_text(LightType type) {
  constexpr std::array<std::string_view, 4> kNames = {"rect", "disk", "sphere", "sun"};
  return kNames[static_cast<size_t>(type)];
}

glm::dvec3 light_point(const Light& light, const glm::dvec2& uv) {
  if (light.type == LightType::rect) {
    return light.center_world + (uv.x - 0.5) * light.size_world.x * light.tangent_world +
           (uv.y - 0.5) * light.size_world.y * light.bitangent_world;
  }
  const glm::dvec2 disk = disk_point(uv);
  const glm::dvec3 lateral = disk.x * light.tangent_world + disk.y * light.bitangent_world;
  if (light.type == LightType::sun) {
    return glm::normalize(std::tan(light.half_angle_rad) * lateral - light.direction_world);
  }
  return light.center_world + light.radius_world * lateral;
}

LightSample sample_light(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world,
                         const glm::dvec2& uv) {
  switch (light.type) {
    case LightType::rect:
      return sample_flat(light, p_world, n_world, light_point(light, uv),
                         light.size_world.x * light.size_world.y);
    case LightType::disk:
      return sample_flat(light, p_world, n_world, light_point(light, uv),
                         std::numbers::pi * light.radius_world * light.radius_world);
    case LightType::sphere:
      return sample_sphere(light, p_world, n_world, uv);
    case LightType::sun:
      break;
  }
  LightSample sample;
  sample.to_light_world = light_point(light, uv);
  sample.distance_world = std::numeric_limits<double>::infinity();
  sample.irradiance_weight = std::max(0.0, glm::dot(n_world, sample.to_light_world));
  return sample;
}

namespace {

struct GridMean {
  double irradiance = 0.0;
  bool straddles_horizon = false;
};

/// Midpoint rule on side x side cells of the light.
GridMean mean_over_grid(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world, int side) {
  GridMean mean;
  for (int i = 0; i < side * side; ++i) {
    const glm::dvec2 uv = (glm::dvec2(i % side, i / side) + 0.5) / static_cast<double>(side);
    const double weight = sample_light(light, p_world, n_world, uv).irradiance_weight;
    mean.irradiance += weight / (side * side);
    mean.straddles_horizon |= weight == 0.0;
  }
  return mean;
}

}  // namespace

double unshadowed_irradiance(const Light& light, const glm::dvec3& p_world, const glm::dvec3& n_world) {
  if (is_near_light(light, p_world)) return near_irradiance(light, p_world, n_world);
  const GridMean fine = mean_over_grid(light, p_world, n_world, 8);
  if (fine.straddles_horizon) return mean_over_grid(light, p_world, n_world, 32).irradiance;
  // Richardson: the midpoint rule's error falls with the square of the cell's side.
  const GridMean coarse = mean_over_grid(light, p_world, n_world, 4);
  return (4.0 * fine.irradiance - coarse.irradiance) / 3.0;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/near_light.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace umbrameter {
namespace {

using glm::dvec3;
constexpr double kPi = std::numbers::pi;
constexpr double kEdgeOn =
    1e-6;  // of the light's half width: a receiver in its plane, as far as floats can tell

double half_width(const Light& light) {
  return light.type == LightType::rect ? 0.5 * std::max(light.size_world.x, light.size_world.y)
                                       : light.radius_world;
}

/// Corners of a flat light as seen from `p_world`.
std::vector<dvec3> outline_of(const Light& light, const dvec3& p_world) {
  const dvec3 center = light.center_world - p_world;
  const dvec3 a = 0.5 * light.size_world.x * light.tangent_world;
  const dvec3 b = 0.5 * light.size_world.y * light.bitangent_world;
  if (light.type == LightType::rect) return {center - a - b, center + a - b, center + a + b, center - a + b};
  constexpr int kCorners = 64;
  const double step_rad = 2.0 * kPi / kCorners;
  const double radius_world = light.radius_world * std::sqrt(step_rad / std::sin(step_rad));
  std::vector<dvec3> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle_rad = step_rad * (i + 0.5);
    corners.push_back(center + radius_world * (std::cos(angle_rad) * light.tangent_world +
                                               std::sin(angle_rad) * light.bitangent_world));
  }
  return corners;
}

/// What of a convex polygon lies above the horizon.
std::vector<dvec3> above_horizon(const std::vector<dvec3>& corners, const dvec3& n_world) {
  std::vector<dvec3> out;
  for (size_t i = 0; i < corners.size(); ++i) {
    const dvec3 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const double h0 = glm::dot(n_world, from), h1 = glm::dot(n_world, to);
    if (h0 > 0.0) out.push_back(from);
    if ((h0 > 0.0) != (h1 > 0.0)) out.push_back(from + (to - from) * (h0 / (h0 - h1)));
  }
  return out;
}

/// Lambert's sum over edges: half their angles, each times the cosine to the normal of its plane.
double polygon_irradiance(const std::vector<dvec3>& corners, const dvec3& n_world) {
  double sum = 0.0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const dvec3 normal = glm::cross(a, b);
    const double length = glm::length(normal);
    if (length > 0.0) sum += std::atan2(length, glm::dot(a, b)) * glm::dot(normal, n_world) / length;
  }
  return 0.5 * std::abs(sum);
}

/// A sphere cut by the horizon (Snyder 1996, in the form for spheres of radius 1 at distance h).
double sphere_irradiance(const Light& light, const dvec3& p_world, const dvec3& n_world) {
  const dvec3 to_center = light.center_world - p_world;
  const double distance = glm::length(to_center), h = distance / light.radius_world;
  if (!(h > 1.0)) return 0.0;
  const double cosine = glm::dot(n_world, to_center) / distance;
  const double cut = 1.0 - h * h * cosine * cosine;
  if (cut <= 0.0) return cosine > 0.0 ? kPi * cosine / (h * h) : 0.0;
  const double beyond = h * h - 1.0;
  const double root = std::clamp(-cosine * std::sqrt(beyond / (1.0 - cosine * cosine)), -1.0, 1.0);
  const double cap = cosine * std::acos(root) - std::sqrt(cut * beyond);
  return std::max(0.0, cap / (h * h) + std::atan(std::sqrt(cut / beyond)));
}

}  // namespace

bool is_near_light(const Light& light, const dvec3& p_world) {
  if (light.type == LightType::sun) return false;
  const dvec3 offset = p_world - light.center_world;
  if (light.type == LightType::sphere) return glm::length(offset) < 2.0 * light.radius_world;
  return glm::dot(offset, light.direction_world) < half_width(light);
}

double near_irradiance(const Light& light, const dvec3& p_world, const dvec3& n_world) {
  if (light.type == LightType::sphere) return sphere_irradiance(light, p_world, n_world);
  const double height_world = glm::dot(p_world - light.center_world, light.direction_world);
  if (height_world <= kEdgeOn * half_width(light)) return 0.0;
  return polygon_irradiance(above_horizon(outline_of(light, p_world), n_world), n_world);
}

}  // namespace umbrameter

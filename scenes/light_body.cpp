// SPDX-License-Identifier: Apache-2.0
#include "scenes/light_body.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr double kShrink = 1e-3;  // of the light's size
constexpr int kDiskCorners = 32;

/// Of a flat light, a little smaller than it is.
std::vector<dvec3> outline_of(const Light& light) {
  std::vector<dvec3> corners;
  const auto add = [&](double along, double across) {
    corners.push_back(light.center_world +
                      (1.0 - kShrink) * (along * light.tangent_world + across * light.bitangent_world));
  };
  if (light.type == LightType::rect) {
    const glm::dvec2 half = 0.5 * light.size_world;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) add(x * half.x, y * half.y);
    return corners;
  }
  for (int i = 0; i < kDiskCorners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kDiskCorners;
    add(light.radius_world * std::cos(angle_rad), light.radius_world * std::sin(angle_rad));
  }
  return corners;
}

/// Whether the segment crosses the convex polygon's inside, from one side of its plane to the other.
bool crosses(const dvec3& from, const dvec3& to, std::span<const dvec3> polygon) {
  const dvec3 n = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  const double before = glm::dot(n, from - polygon[0]), after = glm::dot(n, to - polygon[0]);
  if (!((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0))) return false;
  const dvec3 p = from + (to - from) * (before / (before - after));
  for (size_t i = 0; i < polygon.size(); ++i) {
    const dvec3& corner = polygon[i];
    if (glm::dot(n, glm::cross(polygon[(i + 1) % polygon.size()] - corner, p - corner)) < 0.0) return false;
  }
  return true;
}

bool any_edge_crosses(std::span<const dvec3> edges, std::span<const dvec3> polygon) {
  for (size_t i = 0; i < edges.size(); ++i) {
    if (crosses(edges[i], edges[(i + 1) % edges.size()], polygon)) return true;
  }
  return false;
}

double segment_distance(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 ab = b - a;
  const double along = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
  return glm::length(p - a - along * ab);
}

}  // namespace

double triangle_distance(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
  const auto inside = [&](const dvec3& from, const dvec3& to) {
    return glm::dot(n, glm::cross(to - from, p - from)) >= 0;
  };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(glm::dot(p - a, n));
  return std::min({segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
}

Bounds3 light_bounds(const Light& light) {
  Bounds3 bounds;
  if (light.type == LightType::sun) return bounds;
  if (light.type == LightType::sphere)
    return {light.center_world - light.radius_world, light.center_world + light.radius_world};
  for (const dvec3& corner : outline_of(light)) {
    bounds.min = glm::min(bounds.min, corner);
    bounds.max = glm::max(bounds.max, corner);
  }
  return bounds;
}

bool pierces(const Light& light, const dvec3& a, const dvec3& b, const dvec3& c) {
  if (light.type == LightType::sun) return false;
  if (light.type == LightType::sphere)
    return triangle_distance(light.center_world, a, b, c) < (1.0 - kShrink) * light.radius_world;
  const std::array triangle{a, b, c};
  const std::vector<dvec3> outline = outline_of(light);
  return any_edge_crosses(outline, triangle) || any_edge_crosses(triangle, outline);
}

}  // namespace umbrameter

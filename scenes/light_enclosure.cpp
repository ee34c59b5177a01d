// SPDX-License-Identifier: Apache-2.0
#include "scenes/light_enclosure.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr double kTouching = 1e-6;  // of the scene's diagonal; float positions are exact to 6e-8

struct Corners {
  dvec3 a, b, c;
};

Corners corners_of(const Scene& scene, uint32_t triangle) {
  const glm::uvec3& t = scene.triangles[triangle];
  return {scene.positions_world[t.x], scene.positions_world[t.y], scene.positions_world[t.z]};
}

/// Moeller and Trumbore 1997, for distances above 0.
bool crosses(const Corners& t, const dvec3& origin, const dvec3& direction) {
  const dvec3 ab = t.b - t.a;
  const dvec3 ac = t.c - t.a;
  const dvec3 p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return false;
  const dvec3 s = (origin - t.a) / determinant;
  const double u = glm::dot(s, p);
  if (u < 0.0 || u > 1.0) return false;
  const dvec3 q = glm::cross(s, ab);
  const double v = glm::dot(direction, q);
  return v >= 0.0 && u + v <= 1.0 && glm::dot(ac, q) > 0.0;
}

double segment_distance(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 ab = b - a;
  const double along = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
  return glm::length(p - a - along * ab);
}

double triangle_distance(const dvec3& p, const Corners& t) {
  const dvec3 n = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
  const auto inside = [&](const dvec3& from, const dvec3& to) {
    return glm::dot(n, glm::cross(to - from, p - from)) >= 0;
  };
  if (inside(t.a, t.b) && inside(t.b, t.c) && inside(t.c, t.a)) return std::abs(glm::dot(p - t.a, n));
  return std::min(
      {segment_distance(p, t.a, t.b), segment_distance(p, t.b, t.c), segment_distance(p, t.c, t.a)});
}

Bounds3 bounds_of(const Scene& scene, const MeshPart& part) {
  Bounds3 bounds;
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    const Corners corners = corners_of(scene, t);
    bounds.min = glm::min(bounds.min, glm::min(corners.a, glm::min(corners.b, corners.c)));
    bounds.max = glm::max(bounds.max, glm::max(corners.a, glm::max(corners.b, corners.c)));
  }
  return bounds;
}

bool contains(const Bounds3& bounds, const dvec3& p, double margin) {
  return glm::all(glm::greaterThanEqual(p, bounds.min - margin)) &&
         glm::all(glm::lessThanEqual(p, bounds.max + margin));
}

bool is_inside(const Scene& scene, const MeshPart& part, const dvec3& p) {
  // No direction along an axis or a diagonal, where edges of man-made things are hit.
  constexpr std::array<std::array<double, 3>, 3> kDirections = {
      {{0.5463, 0.7071, 0.4491}, {-0.6317, 0.3713, 0.6805}, {0.2917, -0.8563, -0.4263}}};
  int odd_rays = 0;
  for (const auto& [x, y, z] : kDirections) {
    int crossings = 0;
    for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
      crossings += crosses(corners_of(scene, t), p, {x, y, z}) ? 1 : 0;
    }
    odd_rays += crossings % 2;
  }
  return odd_rays >= 2;
}

bool touches(const Scene& scene, const MeshPart& part, const dvec3& p, double distance) {
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    if (triangle_distance(p, corners_of(scene, t)) <= distance) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> find_enclosed_lights(const Scene& scene) {
  std::vector<std::string> warnings;
  const double margin = kTouching * scene.bounds_world.diagonal();
  for (const MeshPart& part : scene.parts) {
    const Bounds3 bounds = bounds_of(scene, part);
    for (const Light& light : scene.lights) {
      const dvec3& p = light.center_world;
      if (light.type == LightType::sun || !contains(bounds, p, margin)) continue;
      if (touches(scene, part, p, margin)) {
        warnings.push_back(fmt::format("the centre of light '{}' lies on '{}'", light.name, part.name));
      } else if (is_inside(scene, part, p) && !is_inside(scene, part, scene.camera.eye_world)) {
        warnings.push_back(fmt::format("light '{}' seems to be inside '{}'", light.name, part.name));
      }
    }
  }
  return warnings;
}

}  // namespace umbrameter

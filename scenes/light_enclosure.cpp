// SPDX-License-Identifier: Apache-2.0
#include "scenes/light_enclosure.h"

#include "scenes/instances.h"
#include "scenes/light_body.h"

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
    const Corners corners = corners_of(scene, t);
    if (triangle_distance(p, corners.a, corners.b, corners.c) <= distance) return true;
  }
  return false;
}

bool overlap(const Bounds3& a, const Bounds3& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

/// Whether the part reaches into the light's body.
bool is_pierced(const Scene& scene, const MeshPart& part, const Light& light) {
  const Bounds3 body = light_bounds(light);
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    const auto [a, b, c] = corners_of(scene, t);
    const Bounds3 bounds{glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
    if (overlap(bounds, body) && pierces(light, a, b, c)) return true;
  }
  return false;
}

/// With lights and camera of `scene`.
Scene only_instance(const Instance& instance, const Scene& scene) {
  auto mesh = std::make_shared<InstancedMesh>(*instance.mesh);
  mesh->world_from_mesh = {*instance.world_from_mesh};
  Scene alone;
  alone.lights = scene.lights;
  alone.camera = scene.camera;
  alone.instanced = {std::move(mesh)};
  return flattened(alone);
}

bool may_reach(const Instance& instance, const std::vector<Light>& lights, double margin) {
  Bounds3 bounds = instance.bounds_world();
  bounds.min -= margin;
  bounds.max += margin;
  return std::ranges::any_of(lights, [&](const Light& light) {
    return light.type != LightType::sun && overlap(bounds, light_bounds(light));
  });
}

void find_in_parts(const Scene& scene, double margin, std::vector<std::string>& warnings) {
  for (const MeshPart& part : scene.parts) {
    const Bounds3 bounds = bounds_of(scene, part);
    for (const Light& light : scene.lights) {
      const dvec3& p = light.center_world;
      if (light.type == LightType::sun) continue;
      const bool may_hold = contains(bounds, p, margin);
      if (may_hold && touches(scene, part, p, margin)) {
        warnings.push_back(fmt::format("the centre of light '{}' lies on '{}'", light.name, part.name));
      } else if (overlap(bounds, light_bounds(light)) && is_pierced(scene, part, light)) {
        warnings.push_back(fmt::format("light '{}' is pierced by '{}'", light.name, part.name));
      } else if (may_hold && is_inside(scene, part, p) && !is_inside(scene, part, scene.camera.eye_world)) {
        warnings.push_back(fmt::format("light '{}' seems to be inside '{}'", light.name, part.name));
      }
    }
  }
}

}  // namespace

std::vector<std::string> find_enclosed_lights(const Scene& scene) {
  std::vector<std::string> warnings;
  const double margin = kTouching * scene.bounds_world.diagonal();
  find_in_parts(scene, margin, warnings);
  for (const Instance& instance : list_instances(scene)) {
    if (may_reach(instance, scene.lights, margin))
      find_in_parts(only_instance(instance, scene), margin, warnings);
  }
  return warnings;
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/nearest_caster.h"

#include "scenes/instances.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

/// dot(plane, (p, 1)) >= 0 is kept.
using SidePlanes = std::array<glm::dvec4, 5>;
constexpr size_t kMaxCorners = 3 + std::tuple_size_v<SidePlanes>;

struct Polygon {
  std::array<glm::dvec3, kMaxCorners> corners;
  size_t count = 0;
  void add(const glm::dvec3& p) { corners[count++] = p; }
};

double side(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(plane, glm::dvec4(p, 1.0));
}

/// Sutherland and Hodgman 1974, one plane.
Polygon clipped(const Polygon& polygon, const glm::dvec4& plane) {
  Polygon result;
  for (size_t i = 0; i < polygon.count; ++i) {
    const glm::dvec3& a = polygon.corners[i];
    const glm::dvec3& b = polygon.corners[(i + 1) % polygon.count];
    const double side_a = side(plane, a), side_b = side(plane, b);
    if (side_a >= 0.0) result.add(a);
    if ((side_a >= 0.0) != (side_b >= 0.0)) result.add(glm::mix(a, b, side_a / (side_a - side_b)));
  }
  return result;
}

double nearest_inside(const std::array<glm::dvec3, 3>& triangle, const SidePlanes& planes, double nearest) {
  for (const glm::dvec4& plane : planes) {
    if (std::all_of(triangle.begin(), triangle.end(), [&](const auto& p) { return side(plane, p) < 0.0; })) {
      return nearest;
    }
  }
  Polygon polygon;
  for (const glm::dvec3& p : triangle) polygon.add(p);
  for (const glm::dvec4& plane : planes) polygon = clipped(polygon, plane);
  for (size_t i = 0; i < polygon.count; ++i) nearest = std::min(nearest, polygon.corners[i].z);
  return nearest;
}

/// Whether the instance's box reaches into the planes, nearer than `nearest`.
bool may_be_nearer(const Instance& instance, const glm::dmat4& light_from_world, const SidePlanes& planes,
                   double nearest) {
  const Bounds3 bounds = instance.bounds_world();
  std::array<glm::dvec3, 8> corners;
  for (size_t k = 0; k < 8; ++k) {
    const glm::dvec3 p((k & 1) != 0 ? bounds.max.x : bounds.min.x, (k & 2) != 0 ? bounds.max.y : bounds.min.y,
                       (k & 4) != 0 ? bounds.max.z : bounds.min.z);
    corners[k] = glm::dvec3(light_from_world * glm::dvec4(p, 1.0));
  }
  if (std::ranges::all_of(corners, [&](const glm::dvec3& p) { return p.z >= nearest; })) return false;
  return std::ranges::none_of(planes, [&](const glm::dvec4& plane) {
    return std::ranges::all_of(corners, [&](const glm::dvec3& p) { return side(plane, p) < 0.0; });
  });
}

double nearest_caster(const Scene& scene, const glm::dmat4& light_from_world, const SidePlanes& planes,
                      double far) {
  const glm::dvec4 z_row(light_from_world[0][2], light_from_world[1][2], light_from_world[2][2],
                         light_from_world[3][2]);
  double nearest = far;
  const auto take = [&](const std::array<glm::dvec3, 3>& p_world) {
    const auto not_nearer = [&](const glm::dvec3& p) { return side(z_row, p) >= nearest; };
    if (std::all_of(p_world.begin(), p_world.end(), not_nearer)) return;
    std::array<glm::dvec3, 3> p_light;
    for (size_t i = 0; i < 3; ++i) p_light[i] = glm::dvec3(light_from_world * glm::dvec4(p_world[i], 1.0));
    nearest = nearest_inside(p_light, planes, nearest);
  };
  const auto& p = scene.positions_world;
  for (const glm::uvec3& t : scene.triangles) take({p[t.x], p[t.y], p[t.z]});
  for (const Instance& instance : list_instances(scene)) {
    if (!may_be_nearer(instance, light_from_world, planes, nearest)) continue;
    for (uint32_t t = 0; t < instance.mesh->triangles.size(); ++t) take(instance.corners_world(t));
  }
  return nearest;
}

}  // namespace

double nearest_caster_perspective(const Scene& scene, const glm::dmat4& light_from_world,
                                  const LateralBounds& bounds, double floor, double far) {
  const SidePlanes planes{glm::dvec4(0, 0, 1, -floor), glm::dvec4(1, 0, -bounds.min.x, 0),
                          glm::dvec4(-1, 0, bounds.max.x, 0), glm::dvec4(0, 1, -bounds.min.y, 0),
                          glm::dvec4(0, -1, bounds.max.y, 0)};
  return nearest_caster(scene, light_from_world, planes, far);
}

double nearest_caster_orthographic(const Scene& scene, const glm::dmat4& light_from_world,
                                   const LateralBounds& bounds, double far) {
  const SidePlanes planes{glm::dvec4(0, 0, 0, 1), glm::dvec4(1, 0, 0, -bounds.min.x),
                          glm::dvec4(-1, 0, 0, bounds.max.x), glm::dvec4(0, 1, 0, -bounds.min.y),
                          glm::dvec4(0, -1, 0, bounds.max.y)};
  return nearest_caster(scene, light_from_world, planes, far);
}

}  // namespace umbrameter

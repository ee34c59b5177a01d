// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/triangulate.h"

#include "scenes/obj/ear_clipper.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace umbrameter {
namespace {

using glm::dvec2;
using glm::dvec3;

/// Twice the polygon's area, along its normal; robust for non-planar polygons.
dvec3 newell_normal(std::span<const dvec3> corners) {
  dvec3 sum(0.0);
  for (size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  }
  return sum;
}

/// The greatest of the corners' own normals, for a figure of eight, whose Newell normal is zero.
dvec3 greatest_corner_normal(std::span<const dvec3> corners) {
  dvec3 greatest(0.0);
  for (size_t i = 0; i < corners.size(); ++i) {
    const dvec3& b = corners[(i + 1) % corners.size()];
    const dvec3 normal = glm::cross(b - corners[i], corners[(i + 2) % corners.size()] - b);
    if (glm::dot(normal, normal) > glm::dot(greatest, greatest)) greatest = normal;
  }
  return greatest;
}

/// Drops the axis of the largest normal component, keeping counter-clockwise polygons counter-clockwise.
std::vector<dvec2> project(std::span<const dvec3> corners) {
  dvec3 normal = newell_normal(corners);
  if (normal == dvec3(0.0)) normal = greatest_corner_normal(corners);
  const dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(u, v);
  std::vector<dvec2> flat;
  flat.reserve(corners.size());
  for (const dvec3& p : corners) flat.emplace_back(p[u], p[v]);
  return flat;
}

/// Four left turns are one round, so nothing crosses.
bool is_convex_quad(const std::vector<dvec2>& corners) {
  if (corners.size() != 4) return false;
  for (size_t i = 0; i < 4; ++i) {
    const dvec2 edge = corners[(i + 1) % 4] - corners[i];
    const dvec2 next = corners[(i + 2) % 4] - corners[i];
    if (!(edge.x * next.y - edge.y * next.x > 0.0)) return false;
  }
  return true;
}

/// Which corners are not where the corner before them is.
std::vector<uint32_t> distinct_corners(std::span<const dvec3> corners) {
  std::vector<uint32_t> distinct;
  for (uint32_t i = 0; i < corners.size(); ++i) {
    if (distinct.empty() || corners[i] != corners[distinct.back()]) distinct.push_back(i);
  }
  while (distinct.size() > 1 && corners[distinct.back()] == corners[distinct.front()]) distinct.pop_back();
  return distinct;
}

}  // namespace

Triangulation triangulate(std::span<const dvec3> corners) {
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {.triangles = {{0, 1, 2}}};
  const std::vector<uint32_t> distinct = distinct_corners(corners);
  Triangulation result;
  result.equal_neighbours = corners.size() - distinct.size();
  if (distinct.size() < 3) return result;
  std::vector<dvec3> places;
  places.reserve(distinct.size());
  for (const uint32_t i : distinct) places.push_back(corners[i]);
  std::vector<dvec2> flat = project(places);
  if (is_convex_quad(flat)) {
    result.triangles = {{0, 1, 2}, {0, 2, 3}};
  } else {
    EarClipper clipper(std::move(flat));
    result.triangles = clipper.run();
    result.is_guess = clipper.is_guess();
  }
  for (auto& triangle : result.triangles) {
    for (uint32_t& corner : triangle) corner = distinct[corner];
  }
  return result;
}

}  // namespace umbrameter

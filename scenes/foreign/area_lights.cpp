// SPDX-License-Identifier: Apache-2.0
#include "scenes/foreign/area_lights.h"

#include "scenes/imported_scene.h"
#include "scenes/read_values.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

using glm::dvec3;
using Corners = std::array<dvec3, 3>;

constexpr double kSloppy = 1e-4;  // of lengths: what makes a rectangle, a circle

bool is_length(double value) {
  return value >= kMinLength_world && value <= kMaxLength_world;
}

Corners corners_of(const Primitive& mesh, size_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return {mesh.vertices[t.x].p, mesh.vertices[t.y].p, mesh.vertices[t.z].p};
}

/// The corner of `one` that is none of `other`'s; absent unless there is exactly one.
std::optional<size_t> lone_corner(const Corners& one, const Corners& other) {
  std::optional<size_t> lone;
  for (size_t i = 0; i < 3; ++i) {
    if (std::ranges::find(other, one[i]) != other.end()) continue;
    if (lone) return std::nullopt;
    lone = i;
  }
  return lone;
}

dvec3 normal_of(const Corners& c) {
  return glm::cross(c[1] - c[0], c[2] - c[0]);
}

/// Columns of different length, or not at right angles to each other, make an ellipse of a circle.
bool keeps_round(const dvec3& a, const dvec3& b) {
  const double longest = std::max(glm::length(a), glm::length(b));
  return std::abs(glm::length(a) - glm::length(b)) <= kSloppy * longest &&
         std::abs(glm::dot(a, b)) <= kSloppy * longest * longest;
}

}  // namespace

std::optional<Light> rect_light(const Primitive& world) {
  if (world.triangles.size() != 2) return std::nullopt;
  const Corners one = corners_of(world, 0), other = corners_of(world, 1);
  const auto lone = lone_corner(one, other), far = lone_corner(other, one);
  if (!lone || !far) return std::nullopt;
  const dvec3 corner = one[*lone], next = one[(*lone + 1) % 3], last = one[(*lone + 2) % 3];
  const dvec3 width = last - corner, height = next - corner;
  const double size = glm::length(width) + glm::length(height);
  if (!is_length(glm::length(width)) || !is_length(glm::length(height))) return std::nullopt;
  const bool is_parallelogram = glm::length(corner + width + height - other[*far]) <= kSloppy * size;
  const bool is_right = std::abs(glm::dot(glm::normalize(width), glm::normalize(height))) <= kSloppy;
  const bool agrees = glm::dot(normal_of(one), normal_of(other)) > 0.0;
  if (!is_parallelogram || !is_right || !agrees) return std::nullopt;
  Light light = light_of({}, LightType::rect, 0.5 * (next + last), glm::normalize(normal_of(one)));
  light.tangent_world = glm::normalize(width);
  light.size_world = {glm::length(width), glm::length(height)};
  return light;
}

std::optional<Light> disk_light(const glm::dmat4& world_from_disk, bool& is_exact) {
  const glm::dmat3 m(world_from_disk);
  const dvec3 across = glm::cross(m[0], m[1]);
  const double radius_world = std::sqrt(glm::length(across));
  if (!is_length(radius_world)) return std::nullopt;
  is_exact = keeps_round(m[0], m[1]);
  const double side = glm::determinant(m) < 0.0 ? -1.0 : 1.0;  // outside stays outside
  Light light = light_of({}, LightType::disk, dvec3(world_from_disk[3]), side * glm::normalize(across));
  light.radius_world = radius_world;
  return light;
}

std::optional<Light> sphere_light(const glm::dmat4& world_from_sphere, bool& is_exact) {
  const glm::dmat3 m(world_from_sphere);
  const double radius_world = std::cbrt(std::abs(glm::determinant(m)));
  if (!is_length(radius_world)) return std::nullopt;
  is_exact = keeps_round(m[0], m[1]) && keeps_round(m[1], m[2]) && keeps_round(m[0], m[2]);
  Light light = light_of({}, LightType::sphere, dvec3(world_from_sphere[3]), dvec3(0, -1, 0));
  light.radius_world = radius_world;
  return light;
}

void turn_around(Light& light) {
  light.direction_world = -light.direction_world;
  // A disk's tangent is the one that follows from its direction.
  if (light.type == LightType::disk)
    light.tangent_world = light_of({}, light.type, {}, light.direction_world).tangent_world;
}

}  // namespace umbrameter

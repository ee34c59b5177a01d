// SPDX-License-Identifier: Apache-2.0
#pragma once
// Visibility without sampling, in exact arithmetic: the oracle that the reference is tested against. For
// scenes of a few hundred triangles; seconds, not microseconds.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace umbrameter {

/// A flat one-sided light of any simple outline.
struct PolygonLight {
  glm::dvec3 center_world{0.0};
  glm::dvec3 tangent_world{1, 0, 0};
  glm::dvec3 bitangent_world{0, 0, 1};
  glm::dvec3 direction_world{0, -1, 0};  // the side it emits to
  std::vector<glm::dvec2> corners;       // in (tangent, bitangent) from the centre; at least three
};

PolygonLight rectangle_light(const glm::dvec3& center_world, const glm::dvec3& tangent_world,
                             const glm::dvec3& bitangent_world, const glm::dvec3& direction_world,
                             const glm::dvec2& size_world);

using TriangleCorners = std::array<glm::dvec3, 3>;

/// The part of the light's area that the point `p_world` of a surface with normal `n_world` sees: 1 - area of
/// (the triangles' shadows on the light, seen from p, and the light below p's horizon) / area of the light.
/// Inputs are taken at their exact double values; the answer is exact but for its rounding to double. 0
/// behind the light. Triangles whose plane contains p block nothing. Triangles may cross the planes of light
/// and receiver. Error{input} for an outline that is not a simple polygon with area.
double exact_visibility(std::span<const TriangleCorners> triangles, const glm::dvec3& p_world,
                        const glm::dvec3& n_world, const PolygonLight& light);

}  // namespace umbrameter

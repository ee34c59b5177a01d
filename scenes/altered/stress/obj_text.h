// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes written as OBJ text, so that they take the way that users' meshes take.

#include <glm/vec3.hpp>

#include <array>
#include <string>
#include <vector>

namespace umbrameter {

/// Triangles of their own corners.
struct TriangleSoup {
  std::vector<std::array<glm::dvec3, 3>> triangles;

  /// a b c, a c d: counter-clockwise seen from the side it faces.
  void add_quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);
  /// Horizontal rectangle facing up; corners in x and z.
  void add_sheet(double x0, double x1, double z0, double z1, double y);
};

std::string obj_text(const TriangleSoup& soup);

}  // namespace umbrameter

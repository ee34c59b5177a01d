// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/obj_text.h"

#include <fmt/format.h>

namespace umbrameter {

void TriangleSoup::add_quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                            const glm::dvec3& d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

void TriangleSoup::add_sheet(double x0, double x1, double z0, double z1, double y) {
  add_quad({x0, y, z1}, {x1, y, z1}, {x1, y, z0}, {x0, y, z0});
}

std::string obj_text(const TriangleSoup& soup) {
  std::string text;
  size_t index = 0;
  for (const auto& corners : soup.triangles) {
    for (const glm::dvec3& p : corners) text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", p.x, p.y, p.z);
    text += fmt::format("f {} {} {}\n", index + 1, index + 2, index + 3);
    index += 3;
  }
  return text;
}

}  // namespace umbrameter

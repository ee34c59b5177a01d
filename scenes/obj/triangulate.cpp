// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/triangulate.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <numeric>

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

/// Drops the axis of the largest normal component, keeping counter-clockwise polygons counter-clockwise.
std::vector<dvec2> project(std::span<const dvec3> corners) {
  const dvec3 normal = newell_normal(corners);
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

double twice_area(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  explicit EarClipper(std::vector<dvec2> corners) : corners_(std::move(corners)), left_(corners_.size()) {
    std::iota(left_.begin(), left_.end(), 0u);
  }

  std::vector<std::array<uint32_t, 3>> run() {
    std::vector<std::array<uint32_t, 3>> triangles;
    while (left_.size() > 3) {
      const size_t ear = find_ear();
      triangles.push_back({before(ear), left_[ear], after(ear)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  uint32_t before(size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  uint32_t after(size_t i) const { return left_[(i + 1) % left_.size()]; }

  /// The second corner comes first, so that a convex polygon becomes the usual fan around its first corner.
  size_t find_ear() const {
    for (size_t i = 1; i <= left_.size(); ++i) {
      if (is_ear(i % left_.size())) return i % left_.size();
    }
    return 1;
  }

  bool is_ear(size_t i) const {
    const dvec2& a = corners_[before(i)];
    const dvec2& b = corners_[left_[i]];
    const dvec2& c = corners_[after(i)];
    if (twice_area(a, b, c) <= 0.0) return false;
    for (const uint32_t other : left_) {
      const dvec2& p = corners_[other];
      if (p == a || p == b || p == c) continue;
      if (twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0)
        return false;
    }
    return true;
  }

  std::vector<dvec2> corners_;
  std::vector<uint32_t> left_;
};

}  // namespace

std::vector<std::array<uint32_t, 3>> triangulate(std::span<const dvec3> corners) {
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{0, 1, 2}};
  return EarClipper(project(corners)).run();
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The light's frame in exact arithmetic, and convex polygons clipped in it. For the oracle's own sources.

#include "core/error.h"
#include "reference/exact/exact_visibility.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <vector>

namespace umbrameter::exact {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point3 = Kernel::Point_3;
using Vector3 = Kernel::Vector_3;
using Point2 = Kernel::Point_2;

/// A place seen from the light's frame: x tangent, y bitangent, z along their cross product, in units of the
/// three vectors, so that nothing needs to be unit or at right angles. Ratios of areas do not depend on the
/// units.
struct LightFrame {
  Vector3 center, to_x, to_y, to_z;

  explicit LightFrame(const PolygonLight& light) {
    const Vector3 x = exact(light.tangent_world);
    const Vector3 y = exact(light.bitangent_world);
    const Vector3 z = CGAL::cross_product(x, y);
    const Number scale = z * z;
    if (scale == 0) fail_input("the light's tangent and bitangent span no plane");
    center = exact(light.center_world);
    to_x = CGAL::cross_product(y, z) / scale;
    to_y = CGAL::cross_product(z, x) / scale;
    to_z = z / scale;
  }
  static Vector3 exact(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
  Point3 place(const glm::dvec3& p_world) const {
    const Vector3 offset = exact(p_world) - center;
    return {offset * to_x, offset * to_y, offset * to_z};
  }
};

/// value(p) = normal . (p - origin); the half-space keeps values >= 0.
struct HalfSpace {
  Point3 origin;
  Vector3 normal;
  Number value(const Point3& p) const { return normal * (p - origin); }
};

/// Sutherland and Hodgman's clipping of one convex polygon by one half-space.
inline std::vector<Point3> clip(const std::vector<Point3>& corners, const HalfSpace& half) {
  std::vector<Point3> kept;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Point3& from = corners[i];
    const Point3& to = corners[(i + 1) % corners.size()];
    const Number at_from = half.value(from);
    const Number at_to = half.value(to);
    if (at_from >= 0) kept.push_back(from);
    if (CGAL::sign(at_from) * CGAL::sign(at_to) < 0) {
      kept.push_back(from + (to - from) * (at_from / (at_from - at_to)));
    }
  }
  return kept;
}

/// The pyramid from the receiver over the light's bounding rectangle, cut off at the light's plane.
inline std::vector<HalfSpace> pyramid_over(const std::vector<Point3>& rectangle, const Point3& receiver) {
  std::vector<HalfSpace> sides;
  for (size_t i = 0; i < 4; ++i) {
    const Vector3 normal = CGAL::cross_product(rectangle[i] - receiver, rectangle[(i + 1) % 4] - receiver);
    const bool inwards = normal * (rectangle[(i + 2) % 4] - receiver) > 0;
    sides.push_back({receiver, inwards ? normal : -normal});
  }
  sides.push_back({Point3(0, 0, 0), Vector3(0, 0, receiver.z() > 0 ? 1 : -1)});
  return sides;
}

/// Where the line from the receiver through `q` meets the light's plane.
inline Point2 project(const Point3& receiver, const Point3& q) {
  const Number scale = receiver.z() / (receiver.z() - q.z());
  return {receiver.x() + (q.x() - receiver.x()) * scale, receiver.y() + (q.y() - receiver.y()) * scale};
}

/// The outline's bounding rectangle in the light's plane, counter-clockwise.
inline std::vector<Point3> bounding_rectangle(const PolygonLight& light) {
  glm::dvec2 low = light.corners.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& corner : light.corners) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  return {{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}};
}

/// What of the rectangle in the light's plane lies below the plane through `p_world` at right angles to `n_world`.
inline std::vector<Point3> below_horizon(const LightFrame& frame, const std::vector<Point3>& rectangle,
                                         const PolygonLight& light, const glm::dvec3& p_world,
                                         const glm::dvec3& n_world) {
  const Vector3 n = LightFrame::exact(n_world);
  const Vector3 x = LightFrame::exact(light.tangent_world);
  const Vector3 y = LightFrame::exact(light.bitangent_world);
  // On the light's plane n . (center + x u + y v - p) is linear in (u, v).
  const Number at_center = n * (frame.center - LightFrame::exact(p_world));
  const Vector3 gradient(n * x, n * y, 0);
  const Number gradient2 = gradient * gradient;
  if (gradient2 == 0) return at_center <= 0 ? rectangle : std::vector<Point3>{};
  const Point3 on_horizon = Point3(0, 0, 0) - gradient * (at_center / gradient2);
  return clip(rectangle, {on_horizon, -gradient});
}

}  // namespace umbrameter::exact

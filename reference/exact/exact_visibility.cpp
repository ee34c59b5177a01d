#include "reference/exact/exact_visibility.h"

#include "core/error.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>

namespace umbrameter {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point3 = Kernel::Point_3;
using Vector3 = Kernel::Vector_3;
using Point2 = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

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
std::vector<Point3> clip(const std::vector<Point3>& corners, const HalfSpace& half) {
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
std::vector<HalfSpace> pyramid_over(const std::vector<Point3>& rectangle, const Point3& receiver) {
  std::vector<HalfSpace> sides;
  for (size_t i = 0; i < 4; ++i) {
    const Vector3 normal = CGAL::cross_product(rectangle[i] - receiver, rectangle[(i + 1) % 4] - receiver);
    const bool inwards = normal * (rectangle[(i + 2) % 4] - receiver) > 0;
    sides.push_back({receiver, inwards ? normal : -normal});
  }
  sides.push_back({Point3(0, 0, 0), Vector3(0, 0, receiver.z() > 0 ? 1 : -1)});
  return sides;
}

/// Adds the convex polygon to `polygons`, counter-clockwise and without repeated corners; drops it without
/// area.
void add_polygon(const std::vector<Point2>& corners, std::vector<Polygon>& polygons) {
  Polygon polygon;
  for (const Point2& corner : corners) {
    if (polygon.is_empty() || corner != *(polygon.vertices_end() - 1)) polygon.push_back(corner);
  }
  while (polygon.size() > 1 && *polygon.vertices_begin() == *(polygon.vertices_end() - 1)) {
    polygon.erase(polygon.vertices_end() - 1);
  }
  if (polygon.size() < 3 || polygon.area() == 0) return;
  if (polygon.is_clockwise_oriented()) polygon.reverse_orientation();
  polygons.push_back(polygon);
}

/// The shadow of one triangle on the light's plane, inside the light's bounding rectangle.
void add_shadow(const std::array<Point3, 3>& triangle, const Point3& receiver,
                const std::vector<HalfSpace>& pyramid, std::vector<Polygon>& shadows) {
  if (CGAL::coplanar(triangle[0], triangle[1], triangle[2], receiver)) return;
  std::vector<Point3> corners(triangle.begin(), triangle.end());
  for (const HalfSpace& side : pyramid) corners = clip(corners, side);
  std::vector<Point2> projected;
  for (const Point3& q : corners) {
    const Number scale = receiver.z() / (receiver.z() - q.z());
    projected.emplace_back(receiver.x() + (q.x() - receiver.x()) * scale,
                           receiver.y() + (q.y() - receiver.y()) * scale);
  }
  add_polygon(projected, shadows);
}

/// What of the bounding rectangle lies below the receiver's horizon.
void add_horizon(const LightFrame& frame, const std::vector<Point3>& rectangle, const PolygonLight& light,
                 const glm::dvec3& p_world, const glm::dvec3& n_world, std::vector<Polygon>& shadows) {
  const Vector3 n = LightFrame::exact(n_world);
  const Vector3 x = LightFrame::exact(light.tangent_world);
  const Vector3 y = LightFrame::exact(light.bitangent_world);
  // On the light's plane n . (center + x u + y v - p) is linear in (u, v).
  const Number at_center = n * (frame.center - LightFrame::exact(p_world));
  const Vector3 gradient(n * x, n * y, 0);
  const Number gradient2 = gradient * gradient;
  std::vector<Point3> below;
  if (gradient2 == 0) {
    if (at_center <= 0) below = rectangle;
  } else {
    const Point3 on_horizon = Point3(0, 0, 0) - gradient * (at_center / gradient2);
    below = clip(rectangle, {on_horizon, -gradient});
  }
  std::vector<Point2> corners;
  for (const Point3& q : below) corners.emplace_back(q.x(), q.y());
  add_polygon(corners, shadows);
}

Polygon outline_of(const PolygonLight& light) {
  Polygon outline;
  for (const glm::dvec2& corner : light.corners) outline.push_back({corner.x, corner.y});
  if (outline.size() < 3 || !outline.is_simple()) fail_input("the light's outline is not a simple polygon");
  if (outline.is_clockwise_oriented()) outline.reverse_orientation();
  return outline;
}

std::vector<Point3> bounding_rectangle(const PolygonLight& light) {
  glm::dvec2 low = light.corners.front();
  glm::dvec2 high = low;
  for (const glm::dvec2& corner : light.corners) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  return {{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}};
}

Number area_of(const PolygonSet& set) {
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  Number area = 0;
  for (const auto& part : parts) {
    area += part.outer_boundary().area();  // counter-clockwise: positive; holes are clockwise: negative
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) area += hole->area();
  }
  return area;
}

}  // namespace

PolygonLight rectangle_light(const glm::dvec3& center_world, const glm::dvec3& tangent_world,
                             const glm::dvec3& bitangent_world, const glm::dvec3& direction_world,
                             const glm::dvec2& size_world) {
  const glm::dvec2 half = 0.5 * size_world;
  return {center_world,
          tangent_world,
          bitangent_world,
          direction_world,
          {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}}};
}

double exact_visibility(std::span<const TriangleCorners> triangles, const glm::dvec3& p_world,
                        const glm::dvec3& n_world, const PolygonLight& light) {
  const LightFrame frame(light);
  const Polygon outline = outline_of(light);
  const Vector3 from_light = LightFrame::exact(p_world) - frame.center;
  const Point3 receiver = frame.place(p_world);
  if (receiver.z() == 0 || from_light * LightFrame::exact(light.direction_world) <= 0) return 0.0;

  const std::vector<Point3> rectangle = bounding_rectangle(light);
  const std::vector<HalfSpace> pyramid = pyramid_over(rectangle, receiver);
  std::vector<Polygon> shadows;
  add_horizon(frame, rectangle, light, p_world, n_world, shadows);
  for (const TriangleCorners& t : triangles) {
    add_shadow({frame.place(t[0]), frame.place(t[1]), frame.place(t[2])}, receiver, pyramid, shadows);
  }
  PolygonSet blocked;
  blocked.join(shadows.begin(), shadows.end());
  PolygonSet seen(outline);
  seen.difference(blocked);
  return CGAL::to_double(area_of(seen) / outline.area());
}

}  // namespace umbrameter

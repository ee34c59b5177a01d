// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/exact_visibility.h"

#include "reference/exact/exact_frame.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Polygon_set_2.h>

namespace umbrameter {

namespace {

using namespace exact;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

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
  for (const Point3& q : corners) projected.push_back(project(receiver, q));
  add_polygon(projected, shadows);
}

/// What of the bounding rectangle lies below the receiver's horizon.
void add_horizon(const std::vector<Point3>& below, std::vector<Polygon>& shadows) {
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
  add_horizon(below_horizon(frame, rectangle, light, p_world, n_world), shadows);
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

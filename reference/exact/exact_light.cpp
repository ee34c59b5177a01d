// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/exact_light.h"

#include "reference/exact/exact_frame.h"
#include "reference/exact/light_outline.h"
#include "reference/exact/shadow_arrangement.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <unordered_map>

namespace umbrameter {

namespace {

using namespace exact;
using PlainPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

constexpr double kPanel = 0x1p-20;  // of the way from the light's plane: what lies nearer is the lamp itself

PlainPoint plain(const glm::dvec3& p) {
  return {p.x, p.y, p.z};
}

glm::dvec3 corner_world(const Scene& scene, uint32_t triangle, int k) {
  return scene.positions_world[scene.triangles[triangle][k]];
}

/// The volume between receiver and light, over the light's bounding rectangle and the receiver's horizon.
std::vector<KeptSide> shaft_sides(const PolygonLight& light, const std::vector<glm::dvec3>& rectangle_world,
                                  const ExactReceiver& receiver) {
  const glm::dvec3& p = receiver.p_world;
  std::vector<KeptSide> sides{{p, receiver.n_geometric_world}};
  for (size_t i = 0; i < 4; ++i) {
    const glm::dvec3 along = rectangle_world[(i + 1) % 4] - rectangle_world[i];
    const glm::dvec3 n = glm::cross(rectangle_world[i] - p, along);
    const bool inwards = glm::dot(n, rectangle_world[(i + 2) % 4] - rectangle_world[i]) > 0.0;
    sides.push_back({p, inwards ? n : -n});
  }
  const glm::dvec3 axis = glm::cross(light.tangent_world, light.bitangent_world);
  const double side = glm::dot(axis, p - light.center_world) > 0.0 ? 1.0 : -1.0;
  sides.push_back({light.center_world + kPanel * (p - light.center_world), side * axis});
  return sides;
}

/// The shadows of triangles on the light's plane, as the edges that bound them.
class Shadow {
 public:
  Shadow(const TriangleTree& tree, const LightFrame& frame, const PolygonLight& light,
         const glm::dvec3& p_world, const std::vector<Point3>& rectangle)
      : tree_(tree),
        frame_(frame),
        p_world_(p_world),
        center_world_(light.center_world),
        axis_world_(glm::cross(light.tangent_world, light.bitangent_world)),
        receiver_(frame.place(p_world)),
        pyramid_(pyramid_over(rectangle, receiver_)) {
    pyramid_.back().origin = Point3(0, 0, receiver_.z() * kPanel);
  }

  void add(uint32_t triangle, LoopEdges& edges) {
    std::array<glm::dvec3, 3> corners;
    for (int k = 0; k < 3; ++k) corners[static_cast<size_t>(k)] = corner_world(tree_.scene(), triangle, k);
    // Turned so that all wind the same way, seen from the receiver: shared edges cancel, shadows add up.
    const int turn =
        CGAL::orientation(plain(p_world_), plain(corners[0]), plain(corners[1]), plain(corners[2]));
    if (turn == 0) return;  // edge-on
    if (is_between(corners)) {
      const glm::uvec3 places = tree_.places(triangle);
      for (int k = 0; k < 3; ++k) add_shared(places[k], places[(k + 1) % 3], turn);
      for (size_t k = 0; k < 3; ++k) positions_[places[static_cast<int>(k)]] = corners[k];
      return;
    }
    std::vector<Point3> clipped;
    for (const glm::dvec3& c : corners) clipped.push_back(frame_.place(c));
    for (const HalfSpace& side : pyramid_) clipped = clip(clipped, side);
    std::vector<Point2> projected;
    for (const Point3& q : clipped) projected.push_back(project(receiver_, q));
    edges.add_loop(projected, {.shadow = turn});
  }

  /// The edges of all triangles that shared ones did not cancel.
  void add_uncancelled(LoopEdges& edges) {
    std::unordered_map<uint32_t, Point2> projected;
    const auto place_2 = [&](uint32_t place) {
      const auto found = projected.find(place);
      if (found != projected.end()) return found->second;
      return projected.emplace(place, project(receiver_, frame_.place(positions_.at(place)))).first->second;
    };
    for (const auto& [key, times] : shared_) {
      if (times == 0) continue;
      edges.add_edge(place_2(static_cast<uint32_t>(key >> 32)), place_2(static_cast<uint32_t>(key)),
                     {.shadow = times});
    }
  }

 private:
  /// Certainly clear of the planes of light and receiver: no clipping needed.
  bool is_between(const std::array<glm::dvec3, 3>& corners) const {
    constexpr double kMargin = 1e-9;
    const double whole = glm::dot(axis_world_, p_world_ - center_world_);
    const double error = kMargin * glm::length(axis_world_) * tree_.extent_world() / std::abs(whole);
    for (const glm::dvec3& c : corners) {
      const double way = glm::dot(axis_world_, c - center_world_) / whole;
      if (!(way > kPanel + error && way < 1.0 - error - kMargin)) return false;
    }
    return true;
  }

  void add_shared(uint32_t from, uint32_t to, int turn) {
    const auto [low, high] = std::minmax(from, to);
    shared_[(uint64_t{low} << 32) | high] += from < to ? turn : -turn;
  }

  const TriangleTree& tree_;
  const LightFrame& frame_;
  glm::dvec3 p_world_, center_world_, axis_world_;
  Point3 receiver_;
  std::vector<HalfSpace> pyramid_;
  std::unordered_map<uint64_t, int> shared_;
  std::unordered_map<uint32_t, glm::dvec3> positions_;
};

std::vector<Point2> flat(const std::vector<Point3>& corners) {
  std::vector<Point2> all;
  for (const Point3& q : corners) all.emplace_back(q.x(), q.y());
  return all;
}

std::vector<Point2> flat(const std::vector<glm::dvec2>& corners) {
  std::vector<Point2> all;
  for (const glm::dvec2& q : corners) all.emplace_back(q.x, q.y);
  return all;
}

double area_of(const LoopEdges::Region& region) {
  double twice = 0.0;
  for (const auto& [a, b] : region.boundary) twice += a.x * b.y - a.y * b.x;
  return 0.5 * twice;
}

/// Lambert: twice the irradiance from a polygon of unit radiance is the sum over its edges of angle x (unit normal of
/// the edge's triangle with the receiver) . n. The sign is that of the region's turn.
double irradiance_of(const LoopEdges::Region& region, const PolygonLight& light,
                     const ExactReceiver& receiver) {
  const auto to_point = [&](const glm::dvec2& q) {
    return light.center_world + light.tangent_world * q.x + light.bitangent_world * q.y - receiver.p_world;
  };
  double sum = 0.0;
  for (const auto& [from, to] : region.boundary) {
    const glm::dvec3 a = to_point(from), b = to_point(to);
    const glm::dvec3 n = glm::cross(a, b);
    const double length = glm::length(n);
    if (length > 0.0)
      sum += std::atan2(length, glm::dot(a, b)) * glm::dot(n, receiver.n_shading_world) / length;
  }
  return 0.5 * sum;
}

struct Sums {
  double seen = 0.0, hidden = 0.0;              // area inside the inner polygon
  double seen_outer = 0.0, hidden_outer = 0.0;  // inside the outer one
  double irradiance = 0.0, irradiance_seen = 0.0;
};

Sums sum_up(const std::vector<LoopEdges::Region>& regions, const LightOutline& outline,
            const ExactReceiver& receiver) {
  Sums sums;
  for (const LoopEdges::Region& region : regions) {
    const Winding& w = region.winding;
    if (w.inside_outer == 0) continue;
    const bool is_seen = w.shadow == 0 && w.below == 0;
    const double area = area_of(region);
    (is_seen ? sums.seen_outer : sums.hidden_outer) += area;
    if (w.inside != 0) (is_seen ? sums.seen : sums.hidden) += area;
    if (w.unlit != 0 || !outline.is_flat) continue;
    const double irradiance = irradiance_of(region, outline.polygon, receiver);
    sums.irradiance += irradiance;
    if (is_seen) sums.irradiance_seen += irradiance;
  }
  return sums;
}

}  // namespace

ExactLight exact_light(const TriangleTree& tree, const ExactReceiver& receiver, const Light& light) {
  const glm::dvec3& p = receiver.p_world;
  const double beyond_world = 4.0 * (tree.extent_world() + glm::length(p));
  const LightOutline outline = outline_of(light, p, beyond_world);
  const PolygonLight& polygon = outline.polygon;
  ExactLight result;
  if (polygon.corners.empty()) return result;
  if (outline.is_one_sided && glm::dot(p - polygon.center_world, polygon.direction_world) <= 0.0) {
    result.irradiance_ratio = 0.0;
    return result;
  }
  const LightFrame frame(polygon);
  PolygonLight around = polygon;
  around.corners = outline.outer;
  const std::vector<Point3> rectangle = bounding_rectangle(around);
  std::vector<glm::dvec3> rectangle_world;
  for (const Point3& q : rectangle) {
    rectangle_world.push_back(polygon.center_world + polygon.tangent_world * CGAL::to_double(q.x()) +
                              polygon.bitangent_world * CGAL::to_double(q.y()));
  }

  LoopEdges edges;
  Shadow shadow(tree, frame, polygon, p, rectangle);
  const std::vector<uint32_t> near = tree.near(shaft_sides(polygon, rectangle_world, receiver));
  for (const uint32_t triangle : near) {
    if (!std::ranges::binary_search(receiver.transparent, triangle)) shadow.add(triangle, edges);
  }
  shadow.add_uncancelled(edges);
  result.triangles = near.size();
  result.edges = edges.size();
  edges.add_loop(flat(below_horizon(frame, rectangle, polygon, p, receiver.n_geometric_world)), {.below = 1});
  edges.add_loop(flat(below_horizon(frame, rectangle, polygon, p, receiver.n_shading_world)), {.unlit = 1});
  edges.add_loop(flat(polygon.corners), {.inside = 1});
  edges.add_loop(flat(outline.outer), {.inside_outer = 1});

  const Sums sums = sum_up(edges.regions(), outline, receiver);
  const double low = std::max(sums.seen, outline.area - sums.hidden_outer) / outline.area;
  const double high = std::min(sums.seen_outer, outline.area - sums.hidden) / outline.area;
  result.visibility_low = std::clamp(low, 0.0, 1.0);
  result.visibility_high = std::clamp(high, result.visibility_low, 1.0);
  if (outline.is_flat) {
    result.irradiance_ratio = sums.irradiance != 0.0 ? sums.irradiance_seen / sums.irradiance : 0.0;
  }
  return result;
}

}  // namespace umbrameter

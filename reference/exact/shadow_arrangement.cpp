// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/shadow_arrangement.h"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <functional>
#include <unordered_map>

namespace umbrameter::exact {

namespace {

using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;
using Traits = CGAL::Arr_curve_data_traits_2<SegmentTraits, Winding, std::plus<Winding>>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Face = Arrangement::Face_const_handle;
using Halfedge = Arrangement::Halfedge_const_handle;

template <class Use>
void for_each_halfedge(const Face& face, const Use& use) {
  const auto walk = [&](Arrangement::Ccb_halfedge_const_circulator first) {
    auto edge = first;
    do use(Halfedge(edge));
    while (++edge != first);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) walk(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) walk(*ccb);
}

Winding beyond(const Winding& here, const Halfedge& edge) {
  const int sign = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? -1 : 1;
  return here + sign * edge->curve().data();
}

glm::dvec2 rounded(const Point2& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

}  // namespace

Winding operator+(const Winding& a, const Winding& b) {
  return {a.shadow + b.shadow, a.below + b.below, a.unlit + b.unlit, a.inside + b.inside,
          a.inside_outer + b.inside_outer};
}

Winding operator*(int times, const Winding& w) {
  return {times * w.shadow, times * w.below, times * w.unlit, times * w.inside, times * w.inside_outer};
}

void LoopEdges::add_edge(const Point2& from, const Point2& to, const Winding& winding) {
  const auto order = CGAL::compare_xy(from, to);
  if (order == CGAL::EQUAL) return;
  if (order == CGAL::SMALLER) {
    edges_.push_back({from, to, winding});
  } else {
    edges_.push_back({to, from, -1 * winding});
  }
}

void LoopEdges::add_loop(const std::vector<Point2>& corners, const Winding& winding) {
  for (size_t i = 0; i < corners.size(); ++i) {
    add_edge(corners[i], corners[(i + 1) % corners.size()], winding);
  }
}

std::vector<LoopEdges::Region> LoopEdges::regions() const {
  // to_double() may by default be off by 1e-5.
  [[maybe_unused]] static const bool is_precise = [] {
    Number::set_relative_precision_of_to_double(1e-13);
    return true;
  }();
  std::vector<Traits::X_monotone_curve_2> curves;
  for (const Edge& edge : edges_) {
    curves.emplace_back(SegmentTraits::X_monotone_curve_2(edge.low, edge.high), edge.winding);
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());

  std::vector<Region> regions;
  std::unordered_map<const Arrangement::Face*, Winding> known;
  std::vector<Face> stack{arrangement.unbounded_face()};
  known.emplace(&*stack.back(), Winding{});
  while (!stack.empty()) {
    const Face face = stack.back();
    stack.pop_back();
    Region region{known.at(&*face), {}};
    for_each_halfedge(face, [&](const Halfedge& edge) {
      const Face neighbour = edge->twin()->face();
      if (known.emplace(&*neighbour, beyond(region.winding, edge)).second) stack.push_back(neighbour);
      if (neighbour == face) return;  // an edge inside a region, wound both ways
      region.boundary.emplace_back(rounded(edge->source()->point()), rounded(edge->target()->point()));
    });
    if (!face->is_unbounded()) regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace umbrameter::exact

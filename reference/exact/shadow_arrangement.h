// SPDX-License-Identifier: Apache-2.0
#pragma once
// The light's plane cut up by directed edges, and how often each part is wound around. For the oracle's own sources.

#include "reference/exact/exact_frame.h"

#include <utility>

namespace umbrameter::exact {

/// How often a loop, or a region, is wound around by each kind of outline.
struct Winding {
  int shadow = 0;  // of triangles
  int below = 0;   // the geometric horizon
  int unlit = 0;   // the shading normal's horizon
  int inside = 0;  // the light's inner polygon
  int inside_outer = 0;
  friend bool operator==(const Winding&, const Winding&) = default;
};
Winding operator+(const Winding& a, const Winding& b);
Winding operator*(int times, const Winding& w);

/// Edges that together form closed loops.
class LoopEdges {
 public:
  void add_edge(const Point2& from, const Point2& to, const Winding& winding);
  void add_loop(const std::vector<Point2>& corners, const Winding& winding);

  struct Region {
    Winding winding;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> boundary;  // the region lies on its left
  };
  /// The bounded regions of the exact arrangement of the edges.
  std::vector<Region> regions() const;
  size_t size() const { return edges_.size(); }

 private:
  struct Edge {
    Point2 low, high;  // lexicographic
    Winding winding;   // of the left side over the right, seen from low to high
  };
  std::vector<Edge> edges_;
};

}  // namespace umbrameter::exact

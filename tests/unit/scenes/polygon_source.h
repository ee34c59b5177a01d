// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random polygons on a lattice, whose corners often coincide, lie on one line, or touch an edge.

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace umbrameter {

using Polygon2 = std::vector<glm::ivec2>;
using Cell = std::pair<int, int>;

inline int64_t twice_signed_area(const Polygon2& polygon) {
  int64_t sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::ivec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += int64_t{a.x} * b.y - int64_t{b.x} * a.y;
  }
  return sum;
}

/// A blob of unit cells that grew by chance; 4-connected, without holes, but cells may touch at corners.
inline std::set<Cell> random_cells(std::mt19937& random, int count) {
  std::set<Cell> cells{{0, 0}};
  while (static_cast<int>(cells.size()) < count) {
    auto cell = cells.begin();
    std::advance(cell, std::uniform_int_distribution<size_t>(0, cells.size() - 1)(random));
    constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const auto& step = kSteps[std::uniform_int_distribution<int>(0, 3)(random)];
    cells.insert({cell->first + step[0], cell->second + step[1]});
  }
  return cells;
}

/// The outer boundary of `cells`, counter-clockwise, a corner at every lattice point it passes. Where two cells touch at
/// a corner it turns so that the polygon touches itself there instead of crossing.
inline Polygon2 boundary_of(const std::set<Cell>& cells) {
  const auto has = [&](int x, int y) { return cells.count({x, y}) > 0; };
  // Directions: east, north, west, south. Walks with a cell on the left and none on the right.
  constexpr int kDx[4] = {1, 0, -1, 0}, kDy[4] = {0, 1, 0, -1};
  const auto left_cell = [&](glm::ivec2 p, int d) {
    constexpr int kX[4] = {0, -1, -1, 0}, kY[4] = {0, 0, -1, -1};
    return has(p.x + kX[d], p.y + kY[d]);
  };
  const auto right_cell = [&](glm::ivec2 p, int d) {
    constexpr int kX[4] = {0, 0, -1, -1}, kY[4] = {-1, 0, 0, -1};
    return has(p.x + kX[d], p.y + kY[d]);
  };
  const glm::ivec2 start(cells.begin()->first, cells.begin()->second);  // the lowest of the leftmost column
  Polygon2 polygon;
  glm::ivec2 p = start;
  int direction = 0;
  do {
    polygon.push_back(p);
    p += glm::ivec2(kDx[direction], kDy[direction]);
    for (const int turn : {1, 0, 3}) {  // left first: stays with the cell it walks along
      const int next = (direction + turn) % 4;
      if (!left_cell(p, next) || right_cell(p, next)) continue;
      direction = next;
      break;
    }
  } while (p != start || direction != 0);
  return polygon;
}

/// A square of `size` unit cells a side, slit along a tree of lattice edges that hangs on its boundary: walked on both
/// sides, so that most corners coincide with others.
inline Polygon2 random_slits(std::mt19937& random, int size, int edges) {
  constexpr int kDx[4] = {1, 0, -1, 0}, kDy[4] = {0, 1, 0, -1};
  std::set<Cell> touched;
  std::set<std::pair<Cell, int>> walls;  // directed: from a lattice point
  const auto join = [&](Cell a, int direction) {
    const Cell b{a.first + kDx[direction], a.second + kDy[direction]};
    walls.insert({a, direction});
    walls.insert({b, (direction + 2) % 4});
    touched.insert(a);
    touched.insert(b);
  };
  for (int i = 0; i < size; ++i) join({i, 0}, 0), join({size, i}, 1), join({i, size}, 0), join({0, i}, 1);
  for (int tries = 0; edges > 0 && tries < 1000; ++tries) {
    auto from = touched.begin();
    std::advance(from, std::uniform_int_distribution<size_t>(0, touched.size() - 1)(random));
    const int direction = std::uniform_int_distribution<int>(0, 3)(random);
    const Cell to{from->first + kDx[direction], from->second + kDy[direction]};
    const bool is_inside = to.first > 0 && to.first < size && to.second > 0 && to.second < size;
    if (!is_inside || touched.count(to) > 0) continue;
    join(*from, direction);
    --edges;
  }
  Polygon2 polygon;
  Cell p{0, 0};
  int direction = 0;
  do {
    polygon.emplace_back(p.first, p.second);
    p = {p.first + kDx[direction], p.second + kDy[direction]};
    for (const int turn : {1, 0, 3, 2}) {
      if (walls.count({p, (direction + turn) % 4}) == 0) continue;
      direction = (direction + turn) % 4;
      break;
    }
  } while (p != Cell{0, 0} || direction != 0);
  return polygon;
}

/// Drops some of the corners that lie between their neighbours on a line.
inline Polygon2 without_some_straight(const Polygon2& polygon, std::mt19937& random) {
  Polygon2 result;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::ivec2 a = polygon[(i + polygon.size() - 1) % polygon.size()], b = polygon[i];
    const glm::ivec2 c = polygon[(i + 1) % polygon.size()];
    const bool is_straight = (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
    if (!is_straight || random() % 4 == 0) result.push_back(b);
  }
  return result;
}

/// Corners around the origin at angles in order: simple, with deep notches.
inline Polygon2 random_star(std::mt19937& random, int count) {
  Polygon2 star;
  std::uniform_int_distribution<int> radius(20, 1000);
  for (int i = 0; i < count; ++i) {
    const double angle_rad = 6.283185307179586 * i / count;
    const double r = radius(random);
    star.emplace_back(static_cast<int>(std::lround(r * std::cos(angle_rad))),
                      static_cast<int>(std::lround(r * std::sin(angle_rad))));
  }
  return star;
}

/// A star with a smaller one cut out of its middle, joined by a bridge that is walked both ways.
inline Polygon2 random_ring(std::mt19937& random, int count) {
  Polygon2 outer = random_star(random, count), ring;
  for (glm::ivec2& p : outer) p *= 64;
  Polygon2 hole = random_star(random, count);
  for (glm::ivec2& p : hole) p = {p.x / 8, p.y / 8};  // within 125; the outer one keeps 20 * 64 away
  ring = outer;
  ring.push_back(outer.front());
  for (size_t i = 0; i <= hole.size(); ++i) ring.push_back(hole[(hole.size() - i) % hole.size()]);
  return ring;
}

/// Repeats some corners once or twice.
inline Polygon2 with_repeats(const Polygon2& polygon, std::mt19937& random) {
  Polygon2 result;
  for (const glm::ivec2& p : polygon)
    result.insert(result.end(), random() % 5 == 0 ? 1 + random() % 3 : 1, p);
  return result;
}

}  // namespace umbrameter

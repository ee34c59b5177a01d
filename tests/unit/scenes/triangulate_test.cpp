// SPDX-License-Identifier: Apache-2.0
// Without these: a polygon of a model could lose area, cover something twice, or cast a shadow where it has a notch.
#include "scenes/obj/triangulate.h"

#include "polygon_source.h"

#include <gmock/gmock.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <numbers>

namespace umbrameter {
namespace {

using testing::ElementsAre;

constexpr int kSamplePoints = 4000;

/// On a slanted plane whose normal is (-0.25, -0.5, 1): heights stay exact.
std::vector<glm::dvec3> lifted(const Polygon2& polygon) {
  std::vector<glm::dvec3> corners;
  for (const glm::ivec2& p : polygon) corners.emplace_back(p.x, p.y, 0.25 * p.x + 0.5 * p.y);
  return corners;
}

int64_t turn(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
  return int64_t{b.x - a.x} * (c.y - a.y) - int64_t{b.y - a.y} * (c.x - a.x);
}

/// How often the polygon goes round `p`; sets `is_on_edge` where rounding could tell otherwise.
int winding_number(std::span<const glm::dvec2> polygon, const glm::dvec2& p, bool& is_on_edge) {
  int winding = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    is_on_edge |= std::abs(side) < 1e-9 * (1.0 + glm::distance(a, b));
    if (a.y <= p.y && b.y > p.y && side > 0.0) ++winding;
    if (a.y > p.y && b.y <= p.y && side < 0.0) --winding;
  }
  return winding;
}

/// Area by integers and cover by sample points: every point lies in as many triangles as the polygon goes round it.
void expect_covered_once(const Polygon2& polygon, std::mt19937& random) {
  const Triangulation parts = triangulate(lifted(polygon));
  EXPECT_FALSE(parts.is_guess);
  int64_t twice_area = 0;
  for (const auto& [a, b, c] : parts.triangles) {
    const int64_t part = turn(polygon[a], polygon[b], polygon[c]);
    EXPECT_GE(part, 0) << "a flipped triangle";
    twice_area += part;
  }
  EXPECT_EQ(twice_area, twice_signed_area(polygon));
  std::vector<glm::dvec2> outline(polygon.begin(), polygon.end());
  glm::dvec2 low(1e9), high(-1e9);
  for (const glm::dvec2& p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  std::uniform_real_distribution<double> x(low.x, high.x), y(low.y, high.y);
  for (int i = 0; i < kSamplePoints; ++i) {
    const glm::dvec2 p(x(random), y(random));
    bool is_on_edge = false;
    const int expected = winding_number(outline, p, is_on_edge);
    int covered = 0;
    for (const auto& [a, b, c] : parts.triangles) {
      const std::array triangle{outline[a], outline[b], outline[c]};
      covered += winding_number(triangle, p, is_on_edge);
    }
    if (is_on_edge) continue;
    ASSERT_EQ(covered, expected) << p.x << ", " << p.y;
  }
}

/// Runs `make` with a seed each, so that a failure can be had again.
template <typename Make>
void expect_all_covered_once(uint32_t first_seed, int count, const Make& make) {
  for (uint32_t seed = first_seed; seed < first_seed + static_cast<uint32_t>(count); ++seed) {
    std::mt19937 random(seed);
    const Polygon2 polygon = make(random);
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_covered_once(polygon, random);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Triangulate, StarsWithRepeatedCorners) {
  expect_all_covered_once(1, 600, [](std::mt19937& random) {
    return with_repeats(random_star(random, 4 + static_cast<int>(random() % 40)), random);
  });
}

TEST(Triangulate, BlobsOfCellsThatTouchThemselves) {
  expect_all_covered_once(10001, 700, [](std::mt19937& random) {
    const std::set<Cell> cells = random_cells(random, 1 + static_cast<int>(random() % 30));
    return with_repeats(without_some_straight(boundary_of(cells), random), random);
  });
}

TEST(Triangulate, RingsWithABridge) {
  expect_all_covered_once(20001, 300, [](std::mt19937& random) {
    return with_repeats(random_ring(random, 5 + static_cast<int>(random() % 15)), random);
  });
}

TEST(Triangulate, SquaresWithSlits) {
  expect_all_covered_once(40001, 400, [](std::mt19937& random) {
    return random_slits(random, 2 + static_cast<int>(random() % 6), static_cast<int>(random() % 20));
  });
}

TEST(Triangulate, AnyFirstCornerGivesTheSameArea) {
  expect_all_covered_once(30001, 100, [](std::mt19937& random) {
    Polygon2 polygon = boundary_of(random_cells(random, 12));
    std::rotate(polygon.begin(), polygon.begin() + static_cast<int>(random() % polygon.size()),
                polygon.end());
    return polygon;
  });
}

TEST(Triangulate, RoundPolygonsOfAnySizeAreQuick) {
  const Triangulation quad = triangulate(lifted({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_THAT(quad.triangles, ElementsAre(std::array{0u, 1u, 2u}, std::array{0u, 2u, 3u}));
  Polygon2 round;  // rounding makes a third of its corners reflex
  for (int i = 0; i < 100000; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / 100000;
    round.emplace_back(static_cast<int>(1e8 * std::cos(angle_rad)),
                       static_cast<int>(1e8 * std::sin(angle_rad)));
  }
  const Triangulation parts = triangulate(lifted(round));
  EXPECT_EQ(parts.triangles.size(), 99998u);
  EXPECT_FALSE(parts.is_guess);
  int64_t twice_area = 0;
  for (const auto& [a, b, c] : parts.triangles) twice_area += std::abs(turn(round[a], round[b], round[c]));
  EXPECT_EQ(twice_area, twice_signed_area(round));
}

TEST(Triangulate, EqualNeighboursAreLeftOutAndCounted) {
  const Triangulation ends =
      triangulate(lifted({{0, 0}, {0, 0}, {3, 0}, {3, 3}, {3, 3}, {3, 3}, {0, 3}, {0, 0}}));
  EXPECT_EQ(ends.equal_neighbours, 4u);
  EXPECT_THAT(ends.triangles, ElementsAre(std::array{0u, 2u, 3u}, std::array{0u, 3u, 6u}));
  const Triangulation line = triangulate(lifted({{0, 0}, {1, 1}, {1, 1}, {0, 0}}));
  EXPECT_EQ(line.equal_neighbours, 2u);
  EXPECT_TRUE(line.triangles.empty());
}

TEST(Triangulate, CrossingPolygonsAreSaidToBeAGuess) {
  EXPECT_TRUE(triangulate(lifted({{0, 0}, {2, 2}, {2, 0}, {0, 2}})).is_guess) << "a figure of eight";
  EXPECT_TRUE(triangulate(lifted({{0, 0}, {4, 4}, {4, 0}, {0, 3}})).is_guess) << "one with an area";
  EXPECT_TRUE(triangulate(lifted({{0, 9}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}})).is_guess) << "a pentagram";
  EXPECT_FALSE(triangulate(lifted({{0, 0}, {2, 0}, {1, 0}, {3, 0}})).is_guess) << "a line";
}

}  // namespace
}  // namespace umbrameter

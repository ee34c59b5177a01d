// SPDX-License-Identifier: Apache-2.0
// Two ways to the same exact answer: all triangles united, and only the edges around the shadow of the near ones.

#include "reference/exact/exact_light.h"
#include "reference/exact/exact_visibility.h"
#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <random>
#include <set>

namespace umbrameter {
namespace {

std::vector<TriangleCorners> all_corners(const Scene& scene) {
  std::vector<TriangleCorners> all;
  for (const glm::uvec3& t : scene.triangles) {
    all.push_back({scene.positions_world[t.x], scene.positions_world[t.y], scene.positions_world[t.z]});
  }
  return all;
}

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  glm::dvec3 between(const glm::dvec3& low, const glm::dvec3& high) {
    const double x = (*this)(low.x, high.x);
    const double y = (*this)(low.y, high.y);
    return {x, y, (*this)(low.z, high.z)};
  }

 private:
  std::mt19937 engine_;
};

/// Everything that breaks set operations: a sphere of shared edges, boxes that touch, coplanar sheets that overlap along
/// their edges, duplicates, slivers, and quads through the planes of light and receiver.
Scene hostile_scene(uint32_t seed, double highest) {
  Random random(seed);
  Scene scene;
  add_floor(scene, {8, 8});
  add_sphere(scene, {random(-0.5, 0.5), 1.0, 0.0}, 0.3, 6);
  add_box(scene, {-0.5, 0.5, -0.5}, {0.0, 1.0, 0.0});
  add_box(scene, {0.0, 0.5, -0.5}, {0.5, 1.0, 0.25});
  add_floor(scene, {0.5, 0.5}, 1.5, {0.25, 0.25});
  add_floor(scene, {0.5, 0.5}, 1.5, {0.5, 0.25});
  add_floor(scene, {0.25, 0.5}, 1.5, {0.25, 0.5});
  add_floor(scene, {0.5, 0.5}, 1.5, {0.25, 0.25});
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 corner = random.between({-1.5, -0.5, -1.5}, {1, highest, 1});
    const glm::dvec3 u = random.between({0.1, -0.5, -0.2}, {0.8, 0.5, 0.2});
    const glm::dvec3 v = random.between({-0.2, -0.5, 0.01}, {0.2, 0.5, 0.5});
    add_quad(scene, corner, corner + u, corner + u + v, corner + v);
  }
  scene.lights = {rect_light_above({0.3, 4, -0.2}, {1.5, 1.0})};
  finish_scene(scene);
  return scene;
}

PolygonLight polygon_of(const Light& light) {
  return rectangle_light(light.center_world, light.tangent_world, light.bitangent_world,
                         light.direction_world, light.size_world);
}

void expect_equal_to_union(uint32_t seed, double highest, double tolerance) {
  const Scene scene = hostile_scene(seed, highest);
  const TriangleTree tree(scene);
  const std::vector<TriangleCorners> corners = all_corners(scene);
  Random random(100 + seed);
  size_t partial = 0;
  for (int i = 0; i < 20; ++i) {
    // Multiples of 1/8 put the receiver in line with edges.
    glm::dvec3 p = random.between({-1, 0, -1}, {1, 0, 1});
    if (i % 2 == 0) p = glm::floor(8.0 * p) / 8.0;
    p.y = 1e-9;  // above the floor it lies on
    const glm::dvec3 n = glm::normalize(glm::dvec3(random(-1, 1), 1, random(-1, 1)));
    const ExactLight exact = exact_light(tree, {p, n, n}, scene.light());
    const double united = exact_visibility(corners, p, n, polygon_of(scene.light()));
    EXPECT_NEAR(exact.visibility(), united, tolerance) << "seed " << seed << " point " << i;
    EXPECT_NEAR(exact.visibility_low, exact.visibility_high, 1e-11);
    if (united > 0.001 && united < 0.999) ++partial;
  }
  EXPECT_GT(partial, 8u) << "seed " << seed;
}

TEST(ExactLight, equals_the_union_of_all_triangles_whatever_they_do_to_each_other) {
  for (const uint32_t seed : {1u, 2u, 3u}) expect_equal_to_union(seed, 3.0, 1e-11);
}

TEST(ExactLight, leaves_out_no_more_than_a_millionth_before_the_light) {
  expect_equal_to_union(4, 4.5, 1e-6);
}

TEST(ExactLight, brackets_round_lights_tightly) {
  const std::vector<std::pair<Light, std::function<double(const glm::dvec3&)>>> known{
      {disk_light_above({0, kLightHeight, 0}, 0.5),
       [](const glm::dvec3& p) { return half_plane_disk(p.x, 0.5); }},
      {sphere_light({0, kLightHeight, 0}, 0.5),
       [](const glm::dvec3& p) { return half_plane_sphere(p, 0.5); }},
      {sun_light({0, 1, 0}, 0.1), [](const glm::dvec3& p) { return half_plane_sun(p.x, 0.1); }}};
  for (const auto& [light, visibility] : known) {
    Scene scene = floor_under(light, 0.4);
    add_half_plane(scene);
    finish_scene(scene);
    const TriangleTree tree(scene);
    for (const double x : {-0.08, -0.03, 0.0, 0.01, 0.07}) {
      const glm::dvec3 p{x, 1e-12, 0.05};
      const ExactLight exact = exact_light(tree, {p, {0, 1, 0}, {0, 1, 0}}, light);
      EXPECT_LE(exact.visibility_low, visibility(p) + 1e-9) << to_text(light.type) << " " << x;
      EXPECT_GE(exact.visibility_high, visibility(p) - 1e-9) << to_text(light.type) << " " << x;
      EXPECT_LT(exact.visibility_high - exact.visibility_low, 8e-5) << to_text(light.type) << " " << x;
    }
  }
}

TEST(ExactLight, weighs_the_visible_part_as_lambert_does) {
  const double half = 1.0;
  Scene scene = floor_under(rect_light_above({0, kLightHeight, 0}, {2 * half, 2 * half}), 0.4);
  add_half_plane(scene);
  finish_scene(scene);
  const TriangleTree tree(scene);
  // From x the sheet's edge is seen at on_light = x - x / kFraction; all beyond it is visible.
  for (const double x : {-0.1, 0.0, 0.1}) {
    const ExactLight exact = exact_light(tree, {{x, 1e-12, 0}, {0, 1, 0}, {0, 1, 0}}, scene.light());
    const double edge = x - x / kFraction;
    const double seen = rectangle_irradiance(edge - x, half - x, -half, half, kLightHeight);
    const double all = rectangle_irradiance(-half - x, half - x, -half, half, kLightHeight);
    ASSERT_TRUE(exact.irradiance_ratio);
    EXPECT_NEAR(*exact.irradiance_ratio, seen / all, 1e-9) << x;
  }
}

TEST(ExactLight, a_lamps_own_panel_does_not_hide_it) {
  Scene scene = floor_under(rect_light_above({0, kLightHeight, 0}, {1, 1}), 0.4);
  add_floor(scene, {2, 2}, kLightHeight);
  finish_scene(scene);
  const TriangleTree tree(scene);
  EXPECT_DOUBLE_EQ(exact_light(tree, {{0.1, 1e-12, 0}, {0, 1, 0}, {0, 1, 0}}, scene.light()).visibility(),
                   1.0);
}

TEST(TriangleTree, finds_every_triangle_that_has_a_corner_inside) {
  const Scene scene = hostile_scene(7, 4.5);
  const TriangleTree tree(scene);
  Random random(8);
  for (int i = 0; i < 50; ++i) {
    std::vector<KeptSide> sides;
    for (int k = 0; k < 4; ++k) {
      sides.push_back({random.between({-1, 0, -1}, {1, 2, 1}), random.between({-1, -1, -1}, {1, 1, 1})});
    }
    const auto is_inside = [&](const glm::dvec3& q) {
      return std::ranges::all_of(
          sides, [&](const KeptSide& s) { return glm::dot(s.normal_world, q - s.origin_world) >= 0.0; });
    };
    const std::vector<uint32_t> near = tree.near(sides);
    const std::set<uint32_t> found(near.begin(), near.end());
    EXPECT_EQ(found.size(), near.size());
    for (uint32_t t = 0; t < scene.triangles.size(); ++t) {
      const glm::uvec3 index = scene.triangles[t];
      const bool has_corner = is_inside(scene.positions_world[index.x]) ||
                              is_inside(scene.positions_world[index.y]) ||
                              is_inside(scene.positions_world[index.z]);
      EXPECT_TRUE(!has_corner || found.contains(t)) << t;
    }
  }
}

}  // namespace
}  // namespace umbrameter

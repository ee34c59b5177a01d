// SPDX-License-Identifier: Apache-2.0
// Random clutter has no closed form; exact arithmetic has the answer.

#include "reference/exact/exact_visibility.h"
#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <random>

namespace umbrameter {
namespace {

std::vector<TriangleCorners> corners_of(const Scene& scene) {
  std::vector<TriangleCorners> all;
  for (const glm::uvec3& t : scene.triangles) {
    all.push_back({scene.positions_world[t.x], scene.positions_world[t.y], scene.positions_world[t.z]});
  }
  return all;
}

PolygonLight outline_of(const Light& light, int disk_corners) {
  PolygonLight polygon = rectangle_light(light.center_world, light.tangent_world, light.bitangent_world,
                                         light.direction_world, light.size_world);
  if (light.type == LightType::rect) return polygon;
  polygon.corners.clear();
  for (int i = 0; i < disk_corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / disk_corners;
    polygon.corners.push_back(light.radius_world * glm::dvec2(std::cos(angle_rad), std::sin(angle_rad)));
  }
  return polygon;
}

/// Floor and axis-aligned boxes, whose float positions lie exactly in their planes, under slanted quads that
/// the camera, looking from above their shadows' side, hardly sees. Returns where the quads begin.
uint32_t add_random_clutter(Scene& scene, uint32_t seed) {
  std::mt19937 engine(seed);
  const auto random = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  add_floor(scene, {8, 8});
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 low = glm::vec3(random(-1, 1), random(0, 0.6), random(-1, 1));
    add_box(scene, low, low + glm::dvec3(random(0.1, 0.6), random(0.1, 0.6), random(0.1, 0.6)));
  }
  const auto first_quad = static_cast<uint32_t>(scene.triangles.size());
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 corner(random(-1.5, 1), random(1.2, 4.5),
                            random(-1.5, 1));  // the highest cross the light's plane
    const glm::dvec3 u(random(0.1, 0.8), random(-0.4, 0.4), random(-0.2, 0.2));
    const glm::dvec3 v(random(-0.2, 0.2), random(-0.4, 0.4), random(0.1, 0.8));
    add_quad(scene, corner, corner + u, corner + u + v, corner + v);
  }
  return first_quad;
}

void expect_oracle_agrees(const Light& light, uint32_t seed) {
  Scene scene;
  const uint32_t first_quad = add_random_clutter(scene, seed);
  scene.lights = {light};
  scene.camera.eye_world = {2.5, 1.1, 2.5};
  scene.camera.at_world = {0, 0.2, 0};
  scene.camera.vertical_fov_deg = 35.0;
  finish_scene(scene);
  const Frame frame = render_reference(scene, {.side_px = 16, .samples_per_pixel = 1024, .seed = seed});

  const std::vector<TriangleCorners> triangles = corners_of(scene);
  const PolygonLight polygon = outline_of(light, 64);
  const Image& image = frame.image;
  double error_sum = 0.0, error2 = 0.0, se2 = 0.0, se4 = 0.0;
  size_t penumbra = 0;
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const float id = image.plane("primitive_id")[i];
    if (id < 0.0f || id >= static_cast<float>(first_quad)) continue;
    const glm::dvec3 n{image.plane("normal.x")[i], image.plane("normal.y")[i], image.plane("normal.z")[i]};
    const double exact = exact_visibility(triangles, position_of(frame, i), n, polygon);
    const double e = static_cast<double>(image.plane("visibility")[i]) - exact;
    const double s = static_cast<double>(image.plane("visibility_se")[i]);
    ASSERT_LT(std::abs(e), 8.0 * s + 1e-3) << "pixel " << i << " exact " << exact << " se " << s;
    if (exact < 0.01 || exact > 0.99) continue;
    ++penumbra;
    error_sum += e;
    error2 += e * e;
    se2 += s * s;
    se4 += s * s * s * s;
  }
  EXPECT_GT(penumbra, 20u);
  EXPECT_LT(std::abs(error_sum), 4.0 * std::sqrt(se2));
  EXPECT_LT(std::abs(error2 / se2 - 1.0), 4.0 * std::sqrt((2.0 + 2.0 / 7.0) * se4) / se2);
}

TEST(Oracle, agrees_under_rectangles_in_random_clutter) {
  expect_oracle_agrees(rect_light_above({0.3, 4, -0.2}, {1.5, 1.0}), 1);
  expect_oracle_agrees(rect_light_above({-0.8, 3, 0.5}, {0.7, 2.0}), 2);
}

TEST(Oracle, agrees_under_a_disk_in_random_clutter) {
  // 64 corners lack 0.16 % of the disk: at most 8e-4 in visibility, which the floor of 1e-3 allows.
  expect_oracle_agrees(disk_light_above({0.3, 4, -0.2}, 0.8), 3);
}

TEST(ExactVisibility, equals_the_separable_overlap) {
  const PolygonLight light =
      rectangle_light({0, kLightHeight, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {1.0, 0.6});
  Scene plate;
  add_floor(plate, {0.25, 0.5}, kOccluderHeight);
  for (const double x : {0.0, 0.1, 0.17, 0.4}) {
    const glm::dvec3 p{x, 0, 0.05};
    EXPECT_NEAR(exact_visibility(corners_of(plate), p, {0, 1, 0}, light),
                plate_rect(p, {0.125, 0.25}, {1.0, 0.6}), 1e-15);
  }
}

TEST(ExactVisibility, overlapping_occluders_count_once) {
  const PolygonLight light = rectangle_light({0, kLightHeight, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {1, 1});
  Scene scene;
  add_half_plane(scene);
  add_half_plane(scene);
  add_floor(scene, {10, 20}, 2.0, {-5, 0});
  EXPECT_DOUBLE_EQ(exact_visibility(corners_of(scene), {0, 0, 0}, {0, 1, 0}, light), 0.5);
}

TEST(ExactVisibility, the_horizon_hides_what_lies_below_it) {
  const PolygonLight light = rectangle_light({0, 4, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {2, 2});
  // A wall at x = 0.5 facing +x sees the quarter x > 0.5 of the light's width [-1, 1].
  EXPECT_DOUBLE_EQ(exact_visibility({}, {0.5, 0, 0}, {1, 0, 0}, light), 0.25);
  EXPECT_DOUBLE_EQ(exact_visibility({}, {0.5, 0, 0}, {0, 1, 0}, light), 1.0);
  EXPECT_DOUBLE_EQ(exact_visibility({}, {0.5, 0, 0}, {0, -1, 0}, light), 0.0);
  EXPECT_DOUBLE_EQ(exact_visibility({}, {0.5, 5, 0}, {0, 1, 0}, light), 0.0);  // behind the light
}

TEST(ExactVisibility, triangles_may_cross_the_planes_of_light_and_receiver) {
  const PolygonLight light = rectangle_light({0, 4, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {2, 2});
  // A wall in the plane x = 0.5, from below the floor to above the light: from x = 0 nothing beyond 0.5 / y
  // of the way is hidden but by the part with y < 4: the shadow begins where the wall meets the light, x >
  // 0.5.
  Scene wall;
  add_quad(wall, {0.5, -1, -9}, {0.5, -1, 9}, {0.5, 9, 9}, {0.5, 9, -9});
  EXPECT_DOUBLE_EQ(exact_visibility(corners_of(wall), {0, 0, 0}, {0, 1, 0}, light), 0.75);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these a shadow map could silently miss receivers or casters, or disagree with the depth maths.

#include "realtime/views/light_view.h"
#include "core/spaces.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

void add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
  const auto first = static_cast<uint32_t>(scene.positions_world.size());
  for (const glm::vec3& p : {corner, corner + u, corner + u + v, corner + v}) {
    scene.positions_world.edit().push_back(p);
    scene.bounds_world.min = glm::min(scene.bounds_world.min, glm::dvec3(p));
    scene.bounds_world.max = glm::max(scene.bounds_world.max, glm::dvec3(p));
  }
  scene.triangles.edit().emplace_back(first, first + 1, first + 2);
  scene.triangles.edit().emplace_back(first, first + 2, first + 3);
}

Light light_above(LightType type) {
  Light light;
  light.type = type;
  light.center_world = {0.3, 4, -0.2};
  light.size_world = {1.0, 0.5};
  light.radius_world = 0.5;
  light.half_angle_rad = 0.02;
  return light;
}

/// A floor at y = 0 and a plate at y = 1, with the light 4 above the floor.
Scene plate_scene(LightType type) {
  Scene scene;
  add_quad(scene, {-3, 0, -3}, {6, 0, 0}, {0, 0, 6});
  add_quad(scene, {-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1});
  scene.lights = {light_above(type)};
  return scene;
}

const ReceiverTile kFloorTiles[] = {{{-1, 0, -1}, {0, 0, 2}}, {{0, 0, -1}, {2, 0.1f, 1}}};

std::vector<glm::dvec3> corners(const ReceiverTile& tile) {
  std::vector<glm::dvec3> result;
  for (int i = 0; i < 8; ++i) {
    result.emplace_back((i & 1) != 0 ? tile.max_world.x : tile.min_world.x,
                        (i & 2) != 0 ? tile.max_world.y : tile.min_world.y,
                        (i & 4) != 0 ? tile.max_world.z : tile.min_world.z);
  }
  return result;
}

bool is_inside(const LightView& view, const glm::dvec3& p_world) {
  const glm::dvec3 p = lateral_and_distance(view, p_world);
  const glm::vec4& b = view.lateral_bounds;
  return p.x >= b.x && p.y >= b.y && p.x <= b.z && p.y <= b.w && p.z >= view.near_world &&
         p.z <= view.far_world;
}

class EveryLight : public testing::TestWithParam<LightType> {};

TEST_P(EveryLight, receiver_corners_are_inside_the_centre_view) {
  const Scene scene = plate_scene(GetParam());
  const LightView view = fit_center_view(scene, kFloorTiles, LightFit::visible);
  for (const ReceiverTile& tile : kFloorTiles) {
    for (const glm::dvec3& p : corners(tile))
      EXPECT_TRUE(is_inside(view, p)) << p.x << " " << p.y << " " << p.z;
  }
}

TEST_P(EveryLight, casters_between_light_and_receivers_are_inside_the_depth_range) {
  const Scene scene = plate_scene(GetParam());
  for (const LightFit fit : {LightFit::visible, LightFit::scene}) {
    const LightView view = fit_center_view(scene, kFloorTiles, fit);
    for (size_t i = 4; i < 8; ++i) EXPECT_TRUE(is_inside(view, glm::dvec3(scene.positions_world[i]))) << i;
  }
}

TEST_P(EveryLight, near_plane_touches_the_nearest_caster) {
  const Scene scene = plate_scene(GetParam());
  const LightView view = fit_center_view(scene, kFloorTiles, LightFit::visible);
  double nearest = 1e30;
  for (size_t i = 4; i < 8; ++i) {
    nearest = std::min(nearest, lateral_and_distance(view, glm::dvec3(scene.positions_world[i])).z);
  }
  EXPECT_NEAR(view.near_world, nearest, 1e-3);
}

TEST_P(EveryLight, clip_coordinates_agree_with_bounds_and_depth_functions) {
  const Scene scene = plate_scene(GetParam());
  const LightView view = fit_center_view(scene, kFloorTiles, LightFit::visible);
  const glm::dvec4 b(view.lateral_bounds);
  for (const glm::dvec3& p_world : {glm::dvec3(0), glm::dvec3(0.5, 1, -0.5), glm::dvec3(-1, 0, 2)}) {
    const glm::dvec3 lateral = lateral_and_distance(view, p_world);
    const glm::dvec4 clip =
        glm::dmat4(view.clip_from_light) * (glm::dmat4(view.light_from_world) * glm::dvec4(p_world, 1.0));
    EXPECT_NEAR(0.5 * clip.x / clip.w + 0.5, (lateral.x - b.x) / (b.z - b.x), 1e-6);
    EXPECT_NEAR(0.5 * clip.y / clip.w + 0.5, (lateral.y - b.y) / (b.w - b.y), 1e-6);
    const double depth = view.is_orthographic ? orthographic_depth(lateral.z, view.near_world, view.far_world)
                                              : perspective_depth(lateral.z, view.near_world, view.far_world);
    EXPECT_NEAR(clip.z / clip.w, depth, 1e-6);
  }
}

TEST_P(EveryLight, receivers_around_and_behind_the_light_give_a_finite_view) {
  const Scene scene = plate_scene(GetParam());
  const ReceiverTile around{{-3, 0, -3}, {3, 8, 3}};
  const ReceiverTile behind{{-1, 6, -1}, {1, 7, 1}};
  for (const ReceiverTile& tile : {around, behind}) {
    const LightView view = fit_center_view(scene, {&tile, 1}, LightFit::visible);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) EXPECT_TRUE(std::isfinite(view.clip_from_light[i][j]));
    }
    EXPECT_LT(view.lateral_bounds.x, view.lateral_bounds.z);
    EXPECT_LT(view.lateral_bounds.y, view.lateral_bounds.w);
    EXPECT_LT(view.near_world, view.far_world);
  }
}

INSTANTIATE_TEST_SUITE_P(lights, EveryLight,
                         testing::Values(LightType::rect, LightType::disk, LightType::sphere, LightType::sun),
                         [](const auto& name) { return std::string(to_text(name.param)); });

TEST(center_view, margin_reaches_the_blockers_of_the_outermost_receiver) {
  // Plate at z = 3, floor at z = 4 below a light of 1 x 0.5: blockers of a floor point lie within
  // (0.5, 0.25) (1/3 - 1/4) = (1/24, 1/48) in tan space. The floor strip is 2 wide: x / z in [-0.25, 0.25].
  Scene scene = plate_scene(LightType::rect);
  scene.lights[0].center_world = {0, 4, 0};
  const ReceiverTile strip{{-1, 0, -1}, {1, 0, 1}};
  const LightView view = fit_center_view(scene, {&strip, 1}, LightFit::visible);
  EXPECT_LE(view.lateral_bounds.x, -0.25 - 1.0 / 24);
  EXPECT_GE(view.lateral_bounds.w, 0.25 + 1.0 / 48);
  EXPECT_LT(view.lateral_bounds.z,
            0.25 + 1.0 / 24 + 0.02);  // and not much farther: rim of 1 %, near 1e-4 early
}

TEST(center_view, margin_at_most_doubles_the_map) {
  Scene scene = plate_scene(LightType::rect);
  scene.lights[0].size_world = {50, 50};
  const ReceiverTile strip{{-0.7f, 0, -1.2f}, {1.3f, 0, 0.8f}};  // 2 x 2 around the point below the light
  const LightView view = fit_center_view(scene, {&strip, 1}, LightFit::visible);
  EXPECT_LE(view.lateral_bounds.z - view.lateral_bounds.x, 2 * 0.5 * 1.03);
  EXPECT_GT(view.lateral_bounds.z - view.lateral_bounds.x, 2 * 0.5);
}

TEST(center_view, a_large_triangle_without_corners_in_the_map_still_sets_the_near_plane) {
  Scene scene;
  add_quad(scene, {-3, 0, -3}, {6, 0, 0}, {0, 0, 6});
  add_quad(scene, {-90, 2, -90}, {180, 0, 0}, {0, 0, 180});
  scene.lights = {light_above(LightType::rect)};
  const LightView view = fit_center_view(scene, kFloorTiles, LightFit::visible);
  EXPECT_NEAR(view.near_world, 2.0, 1e-3);  // 4 - 2
}

TEST(center_view, of_a_sphere_covers_near_and_far_receivers_alike) {
  // Seen from 4 above the floor, near tiles lie to one side and a long strip to the other, 110 deg apart: the
  // middle of their box would aim along the strip and lose the near ones.
  Scene scene;
  add_quad(scene, {-40, 0, -40}, {80, 0, 0}, {0, 0, 80});
  scene.lights = {light_above(LightType::sphere)};
  scene.lights[0].center_world = {0, 4, 0};
  std::vector<ReceiverTile> tiles = {{{4, 0, -1}, {5, 0, 1}}};
  for (int i = 0; i < 20; ++i) {
    const auto x = static_cast<float>(-i);
    tiles.push_back({{x - 1, 0, -1}, {x, 0, 1}});
  }
  const LightView view = fit_center_view(scene, tiles, LightFit::visible);
  for (const ReceiverTile& tile : tiles) {
    for (const glm::dvec3& p : corners(tile)) EXPECT_TRUE(is_inside(view, p)) << p.x;
  }
}

TEST(sample_view, looks_from_the_sampled_point_with_the_plane_of_the_light) {
  const Scene scene = plate_scene(LightType::rect);
  const glm::dvec2 uv(0.9, 0.2);
  const LightView view = fit_sample_view(scene, kFloorTiles, LightFit::visible, uv);
  const glm::dvec3 below = light_point(scene.light(), uv) + 2.0 * scene.light().direction_world;
  const glm::dvec3 lateral = lateral_and_distance(view, below);
  EXPECT_NEAR(lateral.x, 0.0, 1e-6);
  EXPECT_NEAR(lateral.y, 0.0, 1e-6);
  EXPECT_NEAR(lateral.z, 2.0, 1e-6);
  for (const ReceiverTile& tile : kFloorTiles) {
    for (const glm::dvec3& p : corners(tile)) EXPECT_TRUE(is_inside(view, p));
  }
}

TEST(sample_view, of_the_sun_looks_along_the_sampled_direction) {
  const Scene scene = plate_scene(LightType::sun);
  const glm::dvec2 uv(0.7, 0.6);
  const LightView view = fit_sample_view(scene, kFloorTiles, LightFit::visible, uv);
  const glm::dvec3 along = -light_point(scene.light(), uv);
  const glm::dvec3 start = lateral_and_distance(view, {0.1, 0.5, 0.2});
  const glm::dvec3 moved = lateral_and_distance(view, glm::dvec3(0.1, 0.5, 0.2) + 0.4 * along);
  EXPECT_NEAR(glm::length(moved - start - glm::dvec3(0, 0, 0.4)), 0.0, 1e-6);
}

TEST(sun_view, stays_well_conditioned_far_from_the_origin) {
  Scene scene = plate_scene(LightType::sun);
  const glm::vec3 shift(10000, 500, -20000);
  for (glm::vec3& p : scene.positions_world.edit()) p += shift;
  scene.bounds_world.min += glm::dvec3(shift);
  scene.bounds_world.max += glm::dvec3(shift);
  const ReceiverTile tile{glm::vec3(-1, 0, -1) + shift, glm::vec3(2, 0, 2) + shift};
  const LightView view = fit_center_view(scene, {&tile, 1}, LightFit::visible);
  EXPECT_LT(glm::length(glm::vec2(view.lateral_bounds.x, view.lateral_bounds.y)), 10.0f);
  EXPECT_LT(view.far_world, 10.0f);
}

}  // namespace
}  // namespace umbrameter

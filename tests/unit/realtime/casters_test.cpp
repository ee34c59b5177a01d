// SPDX-License-Identifier: Apache-2.0
// Without these a triangle that GL would draw a part of could be left out of a shadow map.

#include "realtime/views/casters.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <random>

namespace umbrameter {
namespace {

constexpr int kPointsATriangle = 20;

/// Boxes all around: beside the map, behind the light, below the floor, inside.
Scene scattered_boxes(const Light& light) {
  Scene scene;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-12.0, 12.0), size(0.05, 1.5);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 corner(place(random), place(random), place(random));
    add_box(scene, corner, corner + glm::dvec3(size(random), size(random), size(random)));
  }
  scene.lights = {light};
  finish_scene(scene);
  return scene;
}

const ReceiverTile kReceivers[] = {{{-1, 0, -1}, {1, 0.2f, 1}}};

/// What GL keeps of a point, in double.
bool is_drawn(const LightView& view, const glm::dvec3& p_world, bool clamps_depth) {
  const glm::dvec4 clip =
      glm::dmat4(view.clip_from_light) * glm::dmat4(view.light_from_world) * glm::dvec4(p_world, 1.0);
  const bool is_beside = std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w;
  return !is_beside && clip.w > 0.0 && (clamps_depth || (clip.z >= 0.0 && clip.z <= clip.w));
}

std::vector<bool> kept_triangles(const Scene& scene, const std::vector<TriangleRange>& ranges) {
  std::vector<bool> kept(scene.triangles.size(), false);
  for (const TriangleRange& range : ranges) {
    for (uint32_t i = 0; i < range.count; ++i) kept.at(range.first + i) = true;
  }
  return kept;
}

struct Count {
  size_t drawn = 0, left_out = 0;
};

/// Random points on every triangle that was left out: none may be drawn.
Count check(const Scene& scene, const LightView& view, bool clamps_depth) {
  const auto kept = kept_triangles(scene, casters_in_view(make_caster_clusters(scene), view, clamps_depth));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Count count;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const glm::uvec3& corners = scene.triangles[i];
    const glm::dvec3 a(scene.positions_world[corners.x]), b(scene.positions_world[corners.y]),
        c(scene.positions_world[corners.z]);
    bool is_any_drawn = false;
    for (int k = 0; k < kPointsATriangle; ++k) {
      double u = share(random), v = share(random);
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      is_any_drawn = is_any_drawn || is_drawn(view, a + u * (b - a) + v * (c - a), clamps_depth);
    }
    count.drawn += is_any_drawn ? 1 : 0;
    count.left_out += kept[i] ? 0 : 1;
    EXPECT_TRUE(kept[i] || !is_any_drawn) << "triangle " << i;
  }
  return count;
}

class Casters : public testing::TestWithParam<LightType> {};

Light light_of(LightType type) {
  if (type == LightType::sun) return sun_light({0.3, 1, 0.1}, 0.02);
  if (type == LightType::sphere) return sphere_light({0.5, 4, 0}, 0.3);
  if (type == LightType::disk) return disk_light_above({0.5, 4, 0}, 0.3);
  return rect_light_above({0.5, 4, 0}, {0.6, 0.4});
}

TEST_P(Casters, nothing_that_gl_draws_is_left_out) {
  const Scene scene = scattered_boxes(light_of(GetParam()));
  for (const LightFit fit : {LightFit::visible, LightFit::full, LightFit::scene, LightFit::none}) {
    const LightView view = fit_center_view(scene, kReceivers, fit);
    const Count clipped = check(scene, view, false);
    EXPECT_GT(clipped.drawn, 0u);
    check(scene, view, true);
  }
  for (const glm::dvec2 uv : {glm::dvec2(0.1, 0.9), glm::dvec2(0.7, 0.2)})
    check(scene, fit_sample_view(scene, kReceivers, LightFit::visible, uv), false);
}

INSTANTIATE_TEST_SUITE_P(Lights, Casters,
                         testing::Values(LightType::rect, LightType::disk, LightType::sphere,
                                         LightType::sun));

/// In order of place clusters are compact, as those of a real mesh.
Scene tiled_floor(const Light& light) {
  Scene scene;
  for (int x = -64; x < 64; ++x) {
    for (int z = -64; z < 64; ++z) add_floor(scene, {0.2, 0.2}, 0.0, {0.2 * x, 0.2 * z});
  }
  scene.lights = {light};
  finish_scene(scene);
  return scene;
}

TEST(CasterClusters, HoldEveryTriangleOnceInOrder) {
  const Scene scene = tiled_floor(light_of(LightType::rect));
  uint32_t next = 0;
  for (const CasterCluster& cluster : make_caster_clusters(scene)) {
    EXPECT_EQ(cluster.triangles.first, next);
    next += cluster.triangles.count;
  }
  EXPECT_EQ(next, scene.triangles.size());
}

TEST(CasterClusters, FloorBesideTheMapIsLeftOut) {
  const Scene scene = tiled_floor(light_of(LightType::rect));
  const LightView view = fit_center_view(scene, kReceivers, LightFit::visible);
  const Count count = check(scene, view, false);
  EXPECT_GT(count.left_out, scene.triangles.size() / 2);
  EXPECT_GT(count.drawn, 0u);
}

TEST(CasterClusters, WhatLiesBeyondTheReceiversIsLeftOutUnlessDepthIsClamped) {
  Scene scene;
  add_floor(scene, {4, 4});
  for (uint32_t i = 0; i < kLeastGap; ++i) add_floor(scene, {4, 4}, -1.0 - 0.001 * i);
  scene.lights = {light_of(LightType::rect)};
  finish_scene(scene);
  const LightView view = fit_center_view(scene, kReceivers, LightFit::visible);
  // The first cluster holds the floor; all others lie below it altogether.
  const auto clusters = make_caster_clusters(scene);
  ASSERT_EQ(casters_in_view(clusters, view, false).size(), 1u);
  EXPECT_EQ(casters_in_view(clusters, view, false).front().count, kClusterTriangles);
  EXPECT_EQ(casters_in_view(clusters, view, true).front().count, scene.triangles.size());
}

TEST(CasterClusters, NeighboursJoinIntoOneRange) {
  const Scene scene = tiled_floor(light_of(LightType::sun));
  const LightView view = fit_center_view(scene, kReceivers, LightFit::scene);
  const auto ranges = casters_in_view(make_caster_clusters(scene), view, false);
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_EQ(ranges.front().count, scene.triangles.size());
}

TEST(CasterClusters, ShortGapsAreDrawn) {
  Scene scene;
  const auto add_triangles = [&](uint32_t count, double x) {
    for (uint32_t i = 0; i < count / 2; ++i) add_floor(scene, {0.1, 0.1}, 0.0, {x, 0.0});
  };
  const uint32_t short_gap = kLeastGap - kClusterTriangles;
  add_triangles(short_gap, 9);  // far beside the map
  add_triangles(kClusterTriangles, 0);
  add_triangles(short_gap, 9);
  add_triangles(kClusterTriangles, 0);
  add_triangles(kLeastGap, 9);
  add_triangles(kClusterTriangles, 0);
  add_triangles(kLeastGap, 9);
  scene.lights = {light_of(LightType::rect)};
  finish_scene(scene);
  const LightView view = fit_center_view(scene, kReceivers, LightFit::visible);
  const auto ranges = casters_in_view(make_caster_clusters(scene), view, false);
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].first, 0u);
  EXPECT_EQ(ranges[0].count, 2 * short_gap + 2 * kClusterTriangles);
  EXPECT_EQ(ranges[1].first, ranges[0].count + kLeastGap);
  EXPECT_EQ(ranges[1].count, kClusterTriangles);
}

TEST(CasterClusters, SceneWithoutTrianglesHasNone) {
  EXPECT_TRUE(make_caster_clusters(Scene{}).empty());
}

}  // namespace
}  // namespace umbrameter

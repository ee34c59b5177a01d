// SPDX-License-Identifier: Apache-2.0
// Techniques that look all around a light, and shadow volumes, which need no map: against what is known of them.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter::test {
namespace {

using testing::IsEmpty;

/// A room around a lamp with a box on each of four sides of it and above: shadows lie in every direction.
Scene room_around(const Light& light) {
  Scene scene;
  add_box(scene, {-3, -0.2, -3}, {3, 0, 3});
  add_box(scene, {-3, 4, -3}, {3, 4.2, 3});
  for (const double side : {-1.0, 1.0}) {
    add_box(scene, {std::min(3 * side, 3.2 * side), 0, -3}, {std::max(3 * side, 3.2 * side), 4, 3});
    add_box(scene, {-3, 0, std::min(3 * side, 3.2 * side)}, {3, 4, std::max(3 * side, 3.2 * side)});
    add_box(scene, {1.5 * side - 0.3, 1.6, -0.3}, {1.5 * side + 0.3, 2.2, 0.3});
    add_box(scene, {-0.3, 1.4, 1.5 * side - 0.3}, {0.3, 2.0, 1.5 * side + 0.3});
  }
  add_box(scene, {-0.4, 2.9, -0.4}, {0.4, 3.1, 0.2});
  scene.camera.eye_world = {2.6, 3.4, 2.7};
  scene.camera.at_world = {-1, 1.2, -1};
  scene.camera.vertical_fov_deg = 75;
  scene.lights = {light};
  finish_scene(scene);
  return scene;
}

double share_apart(const std::vector<float>& a, const std::vector<float>& b, float step) {
  size_t apart = 0;
  for (size_t i = 0; i < a.size(); ++i) apart += std::abs(a[i] - b[i]) > step ? 1 : 0;
  return static_cast<double>(apart) / static_cast<double>(a.size());
}

TEST(AroundTechniques, ParaboloidsSeeWhatCubesSee) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = room_around(sphere_light({0.1, 1.9, 0.05}, 0.1));
  const auto cube = visibility(scene, "hard_cube", {{"face_size", int64_t{1024}}});
  const auto halves = visibility(scene, "hard_paraboloid", {{"half_size", int64_t{2048}}});
  EXPECT_LT(share_apart(cube, halves, 0.5f), 0.005);
  const auto soft_cube = visibility(scene, "pcss_cube", {{"face_size", int64_t{1024}}});
  const auto soft = visibility(scene, "pcss_paraboloid", {{"half_size", int64_t{2048}}});
  EXPECT_LT(mean_difference(soft_cube, soft), 0.004);
  EXPECT_GT(mean_difference(soft_cube, cube), 0.004);
  EXPECT_THAT(render(scene, "pcss_paraboloid", {{"half_size", int64_t{512}}}).warnings, IsEmpty());
}

// The plate is two triangles, whose edge is an arc in the map.
TEST(AroundTechniques, ProjectedCastersCastShadowsOfAnotherShape) {
  UMBRAMETER_REQUIRE_GL();
  const auto error = [](const ParameterValues& parameters) {
    const Frame frame = render(half_plane_scene(light_at_4(LightType::sphere, 0.1)), "hard_paraboloid",
                               with({{"half_size", int64_t{1024}}}, parameters));
    return floor_error(frame, [](const glm::dvec3& p) { return p.x > 0.0 ? 1.0 : 0.0; }).rmse;
  };
  EXPECT_LT(error({}), 0.1);  // a column of pixels may lie in the edge's texel
  EXPECT_GT(error({{"casters", std::string("projected")}, {"polygon_slope", 2.0}}), 0.2);
}

TEST(AroundTechniques, WideDisksOfComparisonsSoften) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = room_around(sphere_light({0.1, 1.9, 0.05}, 0.1));
  const auto hard = visibility(scene, "hard_paraboloid", {{"half_size", int64_t{1024}}});
  const auto none =
      visibility(scene, "pcf_paraboloid", {{"half_size", int64_t{1024}}, {"radius_texels", 0.0}});
  EXPECT_LT(largest_difference(hard, none), 1e-6);
  const auto wide =
      visibility(scene, "pcf_paraboloid", {{"half_size", int64_t{1024}}, {"radius_texels", 8.0}});
  const auto grey = std::count_if(wide.begin(), wide.end(), [](float v) { return v > 0.1f && v < 0.9f; });
  EXPECT_GT(grey, static_cast<long>(wide.size() / 50));
}

TEST(ShadowVolumes, EndWhereTheEdgeOfThePlateDoes) {
  UMBRAMETER_REQUIRE_GL();
  const Frame frame = render(half_plane_scene(light_at_4(LightType::disk, 1.0)), "shadow_volumes");
  const ErrorSummary error = floor_error(frame, [](const glm::dvec3& p) {
    return p.x > 0.0 ? 1.0 : 0.0;  // the edge stands straight below the light's centre
  });
  EXPECT_GT(error.pixels, 1000u);
  EXPECT_EQ(error.worst, 0.0);
}

TEST(ShadowVolumes, AreHardShadowsWithoutTexels) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::sun}) {
    const Scene scene = busy_scene(light_at_4(type, 0.5));
    const auto volumes = visibility(scene, "shadow_volumes");
    const auto map = visibility(scene, "hard", {{"map_size", int64_t{4096}}});
    EXPECT_LT(share_apart(volumes, map, 0.5f), 0.01) << to_text(type);
    EXPECT_GT(std::ranges::count(volumes, 0.0f), static_cast<long>(volumes.size() / 20));
    EXPECT_TRUE(std::ranges::all_of(volumes, [](float v) { return v == 0.0f || v == 1.0f; }));
  }
}

// All around the lamp, and with the camera inside shadows' prisms.
TEST(ShadowVolumes, HoldAllAroundTheLight) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = room_around(sphere_light({0.1, 1.9, 0.05}, 0.1));
  const auto cube = visibility(scene, "hard_cube", {{"face_size", int64_t{2048}}});
  EXPECT_LT(share_apart(visibility(scene, "shadow_volumes"), cube, 0.5f), 0.005);
}

}  // namespace
}  // namespace umbrameter::test

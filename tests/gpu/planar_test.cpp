// SPDX-License-Identifier: Apache-2.0
// Planar projection against closed forms: on its plane it must converge to the truth, elsewhere it must say lit.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

double plate_rmse(int64_t light_samples) {
  return floor_error(render(plate_scene(), "planar", {{"light_samples", light_samples}}), plate_visibility)
      .rmse;
}

TEST(planar, converges_to_the_plate_under_a_rectangular_light) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_LT(plate_rmse(64), 0.5 * plate_rmse(8));
  EXPECT_LT(plate_rmse(256), 0.004);
}

TEST(planar, is_right_on_the_half_plane_under_every_light_it_supports) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sun}) {
    const Light light = light_at_4(type, 1.0);
    const Frame frame = render(half_plane_scene(light), "planar", {{"light_samples", int64_t{256}}});
    const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
    EXPECT_LT(floor_error(frame, truth).rmse, 0.005) << to_text(type);
  }
}

TEST(planar, one_projection_is_the_shadow_from_the_centre_without_stairs) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::rect, 1.0);
  const Frame frame = render(half_plane_scene(light), "planar", {{"light_samples", int64_t{1}}});
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p) > 0.5 ? 1.0 : 0.0; };
  const ErrorSummary error = floor_error(frame, truth);
  EXPECT_LT(error.rmse * error.rmse * static_cast<double>(error.pixels), 90.0) << "at most a pixel a row";
}

TEST(planar, geometry_beyond_the_light_casts_no_anti_shadow) {
  UMBRAMETER_REQUIRE_GL();
  Scene scene = half_plane_scene(light_at_4(LightType::rect, 1.0));
  Scene without = scene;
  add_box(scene, {-3, 5, -3}, {3, 6, 3});
  finish_scene(scene);
  EXPECT_EQ(visibility(scene, "planar"), visibility(without, "planar"));
}

TEST(planar, knows_nothing_off_its_plane) {
  UMBRAMETER_REQUIRE_GL();
  Scene scene;
  add_floor(scene, {6, 6});
  add_box(scene, {-0.5, 0, -0.5}, {0.5, 0.5, 0.5});
  add_floor(scene, {1, 1}, 2.0);  // shades all of the box's top
  scene.lights = {light_at_4(LightType::rect, 0.2)};
  scene.camera.eye_world = {0, 1.5, 5};
  scene.camera.at_world = {0, 0.5, 0};
  finish_scene(scene);
  const Frame frame = render(scene, "planar", {{"light_samples", int64_t{16}}});
  const auto height = frame.image.plane("position.y");
  const auto visible = frame.image.plane("visibility");
  size_t on_top = 0;
  for (size_t i = 0; i < height.size(); ++i) {
    if (std::abs(height[i] - 0.5f) > 1e-4f) continue;
    ++on_top;
    EXPECT_EQ(visible[i], 1.0f);
  }
  EXPECT_GT(on_top, 20u);
}

// A plane of a fixed thickness swallows the casters of a small scene.
TEST(planar, does_not_know_how_large_the_scene_is) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const std::vector<float> nominal = visibility(scene, "planar");
  for (const double scale : {0x1p-20, 0x1p-10, 0x1p20})
    EXPECT_EQ(visibility(scaled_scene(scene, scale), "planar"), nominal) << scale;
}

}  // namespace
}  // namespace umbrameter

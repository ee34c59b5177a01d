// SPDX-License-Identifier: Apache-2.0
// Rays through the picture, against the maps that they must agree with.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbrameter {
namespace {

using namespace test;

/// A low wall across a floor, under a slanting sun; the camera sees the side that its shadow begins at.
Scene low_wall() {
  Scene scene;
  add_floor(scene, {4, 4});
  add_quad(scene, {0, 0, 1}, {0, 0, -1}, {0, 0.3, -1}, {0, 0.3, 1});
  scene.lights = {sun_light({1, 1, 0}, 1e-6)};
  scene.camera.eye_world = {-2.0, 1.5, 0.1};
  scene.camera.at_world = {0, 0.1, 0};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

TEST(contact_shadows, are_the_hard_shadow_of_what_the_camera_sees_within_reach) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues values{{"length_world", 0.5}, {"steps", int64_t{64}}};
  const auto screen = visibility(low_wall(), "contact_shadows", values);
  const auto hard = visibility(low_wall(), "hard");
  EXPECT_LT(mean_difference(screen, hard), 0.02);
  EXPECT_GT(std::ranges::count(hard, 0.0f), 1000);
}

TEST(contact_shadows, find_nothing_beyond_their_reach) {
  UMBRAMETER_REQUIRE_GL();
  const auto v = visibility(low_wall(), "contact_shadows", {{"length_world", 0.0}});
  const auto hard = visibility(low_wall(), "hard");
  EXPECT_LT(std::ranges::count(v, 0.0f), std::ranges::count(hard, 0.0f));
}

TEST(pcf_contact, without_reach_is_pcf_and_with_it_nowhere_brighter) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  const ParameterValues small{{"map_size", int64_t{128}}};
  const auto pcf = visibility(scene, "pcf", small);
  EXPECT_EQ(visibility(scene, "pcf_contact", with(small, {{"length_world", 0.0}})), pcf);
  const auto both = visibility(scene, "pcf_contact", small);
  EXPECT_NE(both, pcf);
  for (size_t i = 0; i < pcf.size(); ++i) ASSERT_LE(both[i], pcf[i]) << i;
}

}  // namespace
}  // namespace umbrameter

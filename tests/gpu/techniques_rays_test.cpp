// SPDX-License-Identifier: Apache-2.0
// Rays through the map, against closed forms and the hard shadow.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using namespace test;

const ParameterValues kManyRays = {
    {"map_size", int64_t{1024}}, {"rays", int64_t{64}}, {"samples", int64_t{32}}};

TEST(smrt, is_within_001_of_the_half_plane_and_the_plate) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    const Light light = light_at_4(type, 1.0);
    const Frame frame = render(half_plane_scene(light), "smrt", kManyRays);
    const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
    EXPECT_LE(floor_error(frame, truth).rmse, 0.01) << to_text(type);
  }
  EXPECT_LE(floor_error(render(plate_scene(), "smrt", kManyRays), plate_visibility).rmse, 0.01);
}

TEST(smrt_cascades, are_within_001_of_the_half_plane_under_a_sun) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::sun, 1.0);
  const Frame frame =
      render(half_plane_scene(light), "smrt_cascades",
             {{"cascade_size", int64_t{1024}}, {"rays", int64_t{64}}, {"samples", int64_t{32}}});
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
  EXPECT_LE(floor_error(frame, truth).rmse, 0.01);
}

TEST(smrt, counts_what_two_blockers_hide_once) {
  UMBRAMETER_REQUIRE_GL();
  // A second plate below the half plane's, well inside its shadow: mean distances err, rays do not.
  const Light light = light_at_4(LightType::rect, 1.0);
  Scene scene = half_plane_scene(light);
  add_floor(scene, {20, 40}, 0.7, {-10.5, 0});
  finish_scene(scene);
  const auto rmse = [&](const char* technique, const ParameterValues& values) {
    return floor_error(render(scene, technique, values),
                       [&](const glm::dvec3& p) { return half_plane_visibility(light, p); })
        .rmse;
  };
  EXPECT_LE(rmse("smrt", kManyRays), 0.02);
}

TEST(smrt, with_a_tiny_light_is_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    const Scene scene = busy_scene(light_at_4(type, 1e-7));
    EXPECT_LT(mean_difference(visibility(scene, "smrt"), visibility(scene, "hard")), 1e-3) << to_text(type);
  }
}

}  // namespace
}  // namespace umbrameter

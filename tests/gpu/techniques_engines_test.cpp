// SPDX-License-Identifier: Apache-2.0
// Techniques that compute what engines compute: where that is the truth, where it is the truth under another light, and their
// own formulas.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

constexpr double kPlateDrop = 1.5;  // from the half plane's plate to its floor

ParameterValues many_taps(const ParameterValues& more) {
  return with({{"map_size", int64_t{2048}}, {"search_taps", int64_t{256}}, {"filter_taps", int64_t{256}}},
              more);
}

/// A sun whose penumbra below the half plane has this half width.
Light sun_of_penumbra(double radius_world) {
  return light_at_4(LightType::sun, 8.0 * radius_world / kPlateDrop);
}

double half_plane_rmse(const Light& light, const std::string& technique, const ParameterValues& parameters,
                       const Light& taken_for) {
  return floor_error(render(half_plane_scene(light), technique, parameters),
                     [&](const glm::dvec3& p) { return half_plane_visibility(taken_for, p); })
      .rmse;
}

TEST(pcss_map_units, the_ratio_of_distances_times_a_lamps_radius_is_exact) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::disk, 1.0);
  const ParameterValues values = many_taps({{"radius_unit", std::string("world")},
                                            {"drop", std::string("ratio")},
                                            {"search_radius", 0.5},
                                            {"penumbra_size", 0.5},
                                            {"most_radius", 100.0}});
  EXPECT_LE(half_plane_rmse(light, "pcss_map_units", values, light), 0.01);
}

TEST(pcss_map_units, a_size_in_ranges_is_the_tangent_of_a_suns_half_angle) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues playcanvas = {{"preset", std::string("playcanvas-sun")}, {"focus", 0.5}};
  const Light light = light_at_4(LightType::sun, 1.0);
  const ParameterValues values =
      many_taps(with(playcanvas, {{"search_radius", 1.0 / 8.0}, {"penumbra_size", 1.0 / 8.0}}));
  EXPECT_LE(half_plane_rmse(light, "pcss_map_units", values, light), 0.01);
  // Unless set it is 1: 45 degrees, whatever the sun. A map fitted to the sun's own penumbra ends before that.
  const ParameterValues whole = many_taps(with(playcanvas, {{"map_fit", std::string("scene")}}));
  EXPECT_LE(half_plane_rmse(light, "pcss_map_units", whole, light_at_4(LightType::sun, 8.0)), 0.02);
}

TEST(pcss_map_units, a_ratio_of_stored_depths_has_no_bound_at_the_near_plane) {
  UMBRAMETER_REQUIRE_GL();
  // The plate lies in the near plane: whatever the sun, the filter is as wide as it may be.
  const ParameterValues values = many_taps({{"radius_unit", std::string("world")},
                                            {"drop", std::string("stored_ratio")},
                                            {"search_radius", 0.3},
                                            {"penumbra_size", 0.02},
                                            {"most_radius", 0.3}});
  for (const double size : {0.1, 1.0}) {
    const Light light = light_at_4(LightType::sun, size);
    EXPECT_LE(half_plane_rmse(light, "pcss_map_units", values, sun_of_penumbra(0.3)), 0.01) << size;
  }
}

TEST(pcss_map_units, shadows_fade_in_over_the_share_of_blockers) {
  UMBRAMETER_REQUIRE_GL();
  // Search and filter have the same taps here, so that the share of blockers is the shadow.
  const ParameterValues values = {{"map_size", int64_t{1024}},
                                  {"radius_unit", std::string("world")},
                                  {"drop", std::string("stored_ratio")},
                                  {"search_radius", 0.3},
                                  {"most_radius", 0.3}};
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 1.0));
  const auto plain = visibility(scene, "pcss_map_units", values);
  const auto faded = visibility(scene, "pcss_map_units", with(values, {{"fade_share", 0.25}}));
  size_t partly = 0;
  for (size_t i = 0; i < plain.size(); ++i) {
    const float shadow = 1.0f - plain[i];
    const float t = std::min(1.0f, shadow / 0.25f);
    ASSERT_NEAR(faded[i], 1.0f - shadow * t * t * (3.0f - 2.0f * t), 1e-5f) << i;
    partly += shadow > 0.0f && t < 1.0f ? 1 : 0;
  }
  EXPECT_GT(partly, 50u);
}

TEST(pcf_disk, bgfx_is_the_wide_filter_of_its_own_pcss) {
  UMBRAMETER_REQUIRE_GL();
  // Both turn the same 16 taps; 2 of 1024 texels are a radius of 0.00390625 half maps.
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 1.0));
  const ParameterValues preset = {{"preset", std::string("bgfx")}};
  const double radius = 2.0 * std::sqrt(1.6) / 1024.0;
  const ParameterValues wide =
      with(preset, {{"fade_share", 0.0}, {"search_radius", radius}, {"most_radius", radius}});
  EXPECT_LT(mean_difference(visibility(scene, "pcf_disk", preset), visibility(scene, "pcss_map_units", wide)),
            1e-3);
}

TEST(dpcf, mixes_the_share_with_a_steeper_one_by_the_ratio) {
  UMBRAMETER_REQUIRE_GL();
  // A disk of 0.5 at the floor is the penumbra of a lamp of radius 0.5 x 2.5 / 1.5; the ratio is 1.5 / 2.5.
  const Light light = light_at_4(LightType::disk, 1.0);
  const Light disk = light_at_4(LightType::disk, 2.5 / 1.5);
  for (const double scale : {0.1, 1.0, 10.0}) {
    const ParameterValues values = {
        {"map_size", int64_t{2048}}, {"search_taps", int64_t{512}}, {"ratio_scale", scale}};
    const double softness = std::min(1.0, 0.6 * scale);
    const auto expected = [&](const glm::dvec3& p) {
      const double shadow = 1.0 - half_plane_visibility(disk, p);
      const double rest = 1.0 - std::abs(2.0 * shadow - 1.0);
      const double steep = 0.5 + 0.5 * (shadow < 0.5 ? -1.0 : 1.0) * (1.0 - rest * rest * rest);
      return 1.0 - (softness * shadow + (1.0 - softness) * steep);
    };
    EXPECT_LE(floor_error(render(half_plane_scene(light), "dpcf", values), expected).rmse, 0.015) << scale;
  }
}

TEST(dpcf, a_radius_in_the_world_is_that_whatever_the_light) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues values = {{"map_size", int64_t{2048}},
                                  {"search_taps", int64_t{512}},
                                  {"radius_base", std::string("world")},
                                  {"radius_world", 0.3},
                                  {"ratio_scale", 10.0}};
  for (const double size : {0.2, 1.0}) {
    EXPECT_LE(half_plane_rmse(light_at_4(LightType::sun, size), "dpcf", values, sun_of_penumbra(0.3)), 0.01)
        << size;
  }
}

TEST(pcss_cone, is_within_001_of_the_half_plane) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::sun, 1.0);
  EXPECT_LE(half_plane_rmse(light, "pcss_cone", many_taps({}), light), 0.01);
}

TEST(pcss_cone, unity_takes_the_sun_for_nine_fifths_as_wide) {
  UMBRAMETER_REQUIRE_GL();
  // 0.3375 of penumbra, less than the 0.56 that it allows.
  const Light light = light_at_4(LightType::sun, 1.0);
  const ParameterValues unity = many_taps({{"preset", std::string("unity-hdrp")}});
  EXPECT_LE(half_plane_rmse(light, "pcss_cone", unity, light_at_4(LightType::sun, 1.8)), 0.01);
  EXPECT_GE(half_plane_rmse(light, "pcss_cone", unity, light), 0.03);
}

TEST(pcss_cone, a_sun_wider_than_allowed_stops_at_the_largest_radius) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues narrow = many_taps({{"max_radius_world", 0.1}});
  EXPECT_LE(half_plane_rmse(light_at_4(LightType::sun, 1.0), "pcss_cone", narrow, sun_of_penumbra(0.1)),
            0.01);
}

TEST(pcss_cone, keeps_a_slope_lit_without_any_bias) {
  UMBRAMETER_REQUIRE_GL();
  Scene scene;
  add_quad(scene, {-3, -1.0, 3}, {3, 1.0, 3}, {3, 1.0, -3}, {-3, -1.0, -3});
  scene.lights = {light_at_4(LightType::sun, 0.5)};
  scene.camera.eye_world = {0.5, 3, 1};
  scene.camera.at_world = {0, 0, 0};
  finish_scene(scene);
  const ParameterValues bare = {{"map_size", int64_t{1024}},   {"receiver_plane", std::string("none")},
                                {"bias_texels", 0.0},          {"normal_offset_texels", 1.0},
                                {"least_filter_texels", 16.0}, {"max_offset_share", 1.0}};
  // Sixteen texels aside a slope of a third lies five texels nearer to the light: far outside a cone of 2 degrees.
  const auto v = visibility(scene, "pcss_cone", bare);
  EXPECT_EQ(*std::ranges::min_element(v), 1.0f);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// What papers and engines compute: their curves against closed forms, their filters against those they stand for.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

const ParameterValues kSmallMap = {{"map_size", int64_t{512}}};

ParameterValues many_taps(const ParameterValues& more) {
  return with({{"map_size", int64_t{2048}}, {"search_taps", int64_t{256}}, {"filter_taps", int64_t{256}}},
              more);
}

ParameterValues curve(const std::string& name, const ParameterValues& more = {}) {
  return many_taps(with({{"penumbra_curve", name},
                         {"curve_base", std::string("light")},
                         {"search_cone", false},
                         {"curve_scale", 1.0},
                         {"curve_radius", 1.0},
                         {"curve_search", 1.0},
                         {"curve_most", 1000.0}},
                        more));
}

/// Against the half plane under `taken_for`.
double half_plane_rmse(const Light& light, const std::string& technique, const ParameterValues& parameters,
                       const Light& taken_for) {
  return floor_error(render(half_plane_scene(light), technique, parameters),
                     [&](const glm::dvec3& p) { return half_plane_visibility(taken_for, p); })
      .rmse;
}

double half_plane_rmse(const Light& light, const std::string& technique, const ParameterValues& parameters) {
  return half_plane_rmse(light, technique, parameters, light);
}

TEST(curves, the_ratio_under_a_lamp_is_the_physical_penumbra) {
  UMBRAMETER_REQUIRE_GL();
  // Half the light over the receiver's distance times (z_r - z_b) / z_b is h (1/z_b - 1/z_r).
  const Light light = light_at_4(LightType::disk, 1.0);
  EXPECT_LE(half_plane_rmse(light, "pcss", curve("ratio")), 0.01);
}

TEST(curves, the_ratio_under_a_sun_is_too_wide_the_nearer_its_camera_stands) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::sun, 1.0);
  const double far = half_plane_rmse(light, "pcss", curve("ratio", {{"curve_camera", 10.0}}));
  const double near = half_plane_rmse(light, "pcss", curve("ratio", {{"curve_camera", 0.5}}));
  EXPECT_LE(far, 0.012);
  EXPECT_GE(near, 2.0 * far);
}

TEST(curves, the_squared_one_is_as_wide_as_its_formula) {
  UMBRAMETER_REQUIRE_GL();
  // Floor 4 and edge 2.5 from the light: radii of 5 x 0.1 ((4 - 2.5) / 2.5)^2 = 0.18 at the floor, the penumbra of a disk
  // of radius 0.18 (4 - 1.5) / 1.5 = 0.3.
  const Light light = light_at_4(LightType::disk, 0.2);
  const ParameterValues values = curve("squared", {{"curve_radius", 5.0}, {"curve_search", 5.0}});
  EXPECT_LE(half_plane_rmse(light, "pcss", values, light_at_4(LightType::disk, 0.6)), 0.01);
}

TEST(curves, the_difference_is_a_share_of_the_range_of_distances) {
  UMBRAMETER_REQUIRE_GL();
  // Near plane at the plate, far plane at the floor: the drop is the whole range, so the radius is curve_radius x 0.1.
  const Light light = light_at_4(LightType::disk, 0.2);
  const ParameterValues values = curve("difference", {{"curve_radius", 1.8}, {"curve_search", 5.0}});
  EXPECT_LE(half_plane_rmse(light, "pcss", values, light_at_4(LightType::disk, 0.6)), 0.01);
}

TEST(curves, radii_in_widths_of_the_map_follow_the_scene) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::sun, 0.5));
  const ParameterValues values = with(kSmallMap, {{"preset", std::string("paper-d")}});
  const auto here = visibility(scene, "pcss", values);
  const auto far = visibility(scaled_scene(scene, 1.0 / 64.0), "pcss", values);
  EXPECT_LT(mean_difference(here, far), 1e-3);
  EXPECT_GT(mean_difference(here, visibility(scene, "hard", kSmallMap)), 1e-3);
}

TEST(curves, a_falloff_lightens_shadows_by_the_drop) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::disk, 0.2);
  const ParameterValues dark = curve("difference", {{"curve_search", 5.0}});
  // The whole drop at a falloff of 0.5 leaves half of the shadow.
  const Frame frame = render(half_plane_scene(light), "pcss", with(dark, {{"curve_falloff", 0.5}}));
  const Frame plain = render(half_plane_scene(light), "pcss", dark);
  const auto lightened = frame.image.plane("visibility");
  const auto before = plain.image.plane("visibility");
  const auto y = frame.image.plane("position.y");
  for (size_t i = 0; i < before.size(); ++i) {
    if (std::abs(y[i]) > 1e-4f) continue;
    ASSERT_NEAR(lightened[i], 0.5f * (1.0f + before[i]), 0.01f) << i;
  }
}

TEST(penumbra_mask, a_wider_search_acts_on_curves_too) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::sun, 0.5));
  const ParameterValues published =
      with(kSmallMap, {{"preset", std::string("paper-d")}, {"search_scale", 1.2}});
  EXPECT_GT(largest_difference(visibility(scene, "penumbra_mask", published),
                               visibility(scene, "penumbra_mask", with(published, {{"search_scale", 3.0}}))),
            0.0);
}

TEST(penumbra_mask, on_a_checkerboard_has_its_own_answer_at_every_other_pixel) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  const ParameterValues half =
      with(kSmallMap, {{"pattern", std::string("checkerboard")}, {"noise_stretch", 1.0}});
  const auto all = visibility(scene, "penumbra_mask", kSmallMap);
  const auto filled = visibility(scene, "penumbra_mask", half);
  for (size_t y = 0; y < 90; ++y) {
    for (size_t x = y & 1; x < 160; x += 2) ASSERT_EQ(filled[y * 160 + x], all[y * 160 + x]) << x << " " << y;
  }
  EXPECT_GT(largest_difference(all, filled), 0.0);
}

TEST(edge_mask, that_is_on_everywhere_is_the_grid_without_a_mask) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  for (const int64_t side : {2, 3, 4, 7}) {
    const ParameterValues masked = with(kSmallMap, {{"filter_shape", std::string("grid")},
                                                    {"filter_width_texels", static_cast<double>(side)},
                                                    {"threshold", 0.0}});
    const ParameterValues grid = with(kSmallMap, {{"grid_taps", side}, {"bilinear", false}});
    EXPECT_EQ(visibility(scene, "edge_mask", masked), visibility(scene, "pcf_bilinear", grid)) << side;
  }
}

TEST(edge_mask_quantised, published_bands_act_whatever_the_size_of_the_scene) {
  UMBRAMETER_REQUIRE_GL();
  for (const double scale : {1.0, 1.0 / 64.0, 64.0}) {
    const Scene scene = scaled_scene(busy_scene(light_at_4(LightType::disk, 0.5)), scale);
    const auto banded = visibility(scene, "edge_mask_quantised", {{"preset", std::string("paper-c-235")}});
    const auto hard = visibility(scene, "hard", {{"map_size", int64_t{1024}}});
    EXPECT_GT(mean_difference(banded, hard), 1e-3) << scale;
  }
}

TEST(pcss, jittered_sets_and_bilinear_taps_are_within_002_of_the_half_plane) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::disk, LightType::sphere, LightType::sun}) {
    const Light light = light_at_4(type, 1.0);
    const ParameterValues jittered = many_taps({{"kernel", std::string("jittered")}});
    EXPECT_LE(half_plane_rmse(light, "pcss", jittered), 0.02) << to_text(type);
    EXPECT_LE(half_plane_rmse(light, "pcss", with(jittered, {{"early_out", true}})), 0.02) << to_text(type);
    EXPECT_LE(half_plane_rmse(light, "pcss", many_taps({{"bilinear_taps", true}})), 0.01) << to_text(type);
  }
}

TEST(pcss, an_early_out_decides_as_the_outermost_ring_does) {
  UMBRAMETER_REQUIRE_GL();
  // One ring is all taps of a set of one: with 4 x 4 taps an early answer is 0 or 1 where the rest would differ little.
  const Scene scene = half_plane_scene(light_at_4(LightType::disk, 1.0));
  const ParameterValues all = {{"kernel", std::string("jittered")}, {"map_size", int64_t{512}}};
  const auto full = visibility(scene, "pcss", all);
  const auto early = visibility(scene, "pcss", with(all, {{"early_out", true}}));
  EXPECT_GT(largest_difference(full, early), 0.0);
  EXPECT_LT(mean_difference(full, early), 0.02);
}

TEST(esm, full_shadow_at_a_half_stretches_what_is_above_it) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::rect, 0.5));
  const auto plain = visibility(scene, "esm", kSmallMap);
  const auto stretched = visibility(scene, "esm", with(kSmallMap, {{"full_shadow_at", 0.5}}));
  for (size_t i = 0; i < plain.size(); ++i) {
    ASSERT_NEAR(stretched[i], std::max(0.0f, 2.0f * plain[i] - 1.0f), 1e-5f) << i;
  }
}

TEST(esm, stored_depth_under_a_sun_is_distance_with_another_exponent) {
  UMBRAMETER_REQUIRE_GL();
  // Linear distances count to a quarter past the far plane, stored depth to the far plane.
  const Scene scene = busy_scene(light_at_4(LightType::sun, 0.5));
  const auto stored =
      visibility(scene, "esm", with(kSmallMap, {{"depth_form", std::string("stored")}, {"exponent", 40.0}}));
  const auto linear = visibility(scene, "esm", with(kSmallMap, {{"exponent", 50.0}}));
  EXPECT_LT(mean_difference(stored, linear), 2e-3);
  const auto another = visibility(scene, "esm", with(kSmallMap, {{"exponent", 20.0}}));
  EXPECT_GT(mean_difference(stored, another), 2.0 * mean_difference(stored, linear));
}

TEST(pcss_vsm, of_stored_depth_is_within_002_of_the_half_plane) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::sun}) {
    const ParameterValues values = many_taps({{"depth_form", std::string("stored")},
                                              {"receiver_plane", std::string("none")},
                                              {"bias_texels", 1.0}});
    EXPECT_LE(half_plane_rmse(light_at_4(type, 1.0), "pcss_vsm", values), 0.02) << to_text(type);
  }
}

TEST(pcf_sampler, one_comparison_is_the_hard_shadow_but_for_its_slope_margin) {
  UMBRAMETER_REQUIRE_GL();
  // A plate over a floor under a light above: no slopes, one blocker, and a margin that is far smaller than its height.
  const Scene scene = plate_scene();
  const ParameterValues one = {{"grid_taps", int64_t{1}}, {"bilinear", false}};
  EXPECT_EQ(visibility(scene, "pcf_sampler", one), visibility(scene, "hard"));
}

TEST(pcf_sampler, bilinear_reads_are_those_that_the_shader_blends) {
  UMBRAMETER_REQUIRE_GL();
  // Samplers place a read to 1/256 of a texel.
  const Scene scene = plate_scene();
  for (const int64_t side : {1, 3, 4}) {
    const ParameterValues values = {{"grid_taps", side}};
    EXPECT_LT(largest_difference(visibility(scene, "pcf_sampler", values),
                                 visibility(scene, "pcf_bilinear", values)),
              0.01)
        << side;
  }
}

/// Where an edge runs along the rows of 16 x 16 points there are 17 shades: errors even over 1/16.
const double kSixteenRows = 1.0 / (16.0 * std::sqrt(12.0));

TEST(backprojection, is_within_its_points_of_the_half_plane_and_the_plate) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues fine = {{"map_size", int64_t{512}}, {"patches", int64_t{256}}};
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sun}) {
    EXPECT_LE(half_plane_rmse(light_at_4(type, 1.0), "backprojection", fine), kSixteenRows) << to_text(type);
  }
  EXPECT_LE(floor_error(render(plate_scene(), "backprojection", fine), plate_visibility).rmse, kSixteenRows);
}

TEST(backprojection, counts_what_two_blockers_hide_once) {
  UMBRAMETER_REQUIRE_GL();
  // A second plate just below the half plane's hides what it hides already.
  const Light light = light_at_4(LightType::rect, 1.0);
  Scene scene = half_plane_scene(light);
  add_floor(scene, {20, 40}, 1.2, {-10.2, 0});
  finish_scene(scene);
  const ParameterValues fine = {{"map_size", int64_t{512}}, {"patches", int64_t{256}}};
  EXPECT_LE(floor_error(render(scene, "backprojection", fine),
                        [&](const glm::dvec3& p) { return half_plane_visibility(light, p); })
                .rmse,
            kSixteenRows);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// The filters over a shadow map: two ways to the same filter must agree, and neutral settings must be the
// simpler one.

#include "tests/gpu/technique_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

using namespace test;

const std::vector<LightType> kLightTypes = {LightType::rect, LightType::disk, LightType::sphere,
                                            LightType::sun};

/// A texel position is up to 512 with rounding of 3e-5; a filter blends by such positions.
constexpr double kRoundingOfWeights = 1e-3;

ParameterValues small_map(ParameterValues values) {
  values["map_size"] = int64_t{512};
  return values;
}

TEST(pcf_disk, of_no_radius_is_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : kLightTypes) {
    const Scene scene = half_plane_scene(light_at_4(type, 0.5));
    const auto disk = visibility(scene, "pcf_disk", small_map({{"radius_texels", 0.0}, {"bilinear", false}}));
    EXPECT_EQ(disk, visibility(scene, "hard", small_map({}))) << to_text(type);
  }
}

TEST(pcf_disk, of_no_radius_with_bilinear_taps_is_a_box_of_one_texel) {
  UMBRAMETER_REQUIRE_GL();
  const auto disk = visibility(plate_scene(), "pcf_disk", small_map({{"radius_texels", 0.0}}));
  const auto box = visibility(plate_scene(), "pcf", small_map({{"filter_width_texels", 1.0}}));
  EXPECT_LT(largest_difference(disk, box), kRoundingOfWeights);
}

TEST(pcf_disk, spreads_an_edge_as_far_as_a_disk_of_its_radius) {
  UMBRAMETER_REQUIRE_GL();
  // A filter moves the edge's step by its mean |x|: 4 r / (3 pi) for a disk, W / 4 for a box. So the disk
  // of radius 6 changes the hard shadow by as much as a box of 32 / pi.
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto hard = visibility(scene, "hard", small_map({}));
  const auto disk = visibility(
      scene, "pcf_disk", small_map({{"radius_texels", 6.0}, {"taps", int64_t{256}}, {"bilinear", false}}));
  const auto box = visibility(scene, "pcf", small_map({{"filter_width_texels", 32.0 / std::numbers::pi}}));
  EXPECT_NEAR(mean_difference(disk, hard) / mean_difference(box, hard), 1.0, 0.03);
}

TEST(pcf_disk, noise_follows_the_seed) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const ParameterValues still = small_map({{"rotation", std::string("none")}});
  EXPECT_NE(visibility(scene, "pcf_disk", small_map({}), 1), visibility(scene, "pcf_disk", small_map({}), 2));
  EXPECT_EQ(visibility(scene, "pcf_disk", still, 1), visibility(scene, "pcf_disk", still, 2));
}

TEST(pcf_bilinear, grids_of_any_size_are_boxes_of_that_width) {
  UMBRAMETER_REQUIRE_GL();
  // n tents of base 2 a texel apart add up to the overlap of a texel with a box n wide.
  for (const LightType type : kLightTypes) {
    const Scene scene = half_plane_scene(light_at_4(type, 0.5));
    for (const int64_t grid : {1, 2, 3, 6}) {
      const auto taps = visibility(scene, "pcf_bilinear", small_map({{"grid_taps", grid}}));
      const auto box = visibility(scene, "pcf", small_map({{"filter_width_texels", double(grid)}}));
      EXPECT_LT(largest_difference(taps, box), kRoundingOfWeights) << grid << " " << to_text(type);
    }
  }
}

TEST(pcf_bilinear, one_single_comparison_is_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const auto tap =
      visibility(scene, "pcf_bilinear", small_map({{"grid_taps", int64_t{1}}, {"bilinear", false}}));
  EXPECT_EQ(tap, visibility(scene, "hard", small_map({})));
}

TEST(pcf_bilinear, without_bilinear_taps_has_one_level_more_than_taps) {
  UMBRAMETER_REQUIRE_GL();
  const auto v = visibility(plate_scene(), "pcf_bilinear", small_map({{"bilinear", false}}));
  for (const float value : v) ASSERT_NEAR(value * 9, std::round(value * 9), 1e-5);
}

TEST(pcf_bilinear, center_weight_draws_towards_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  // Nine taps, one of weight w: the mean of the eight has weight 8 / (8 + w), 1/2 for w = 8 and 8/9 for 1.
  const Scene scene = plate_scene();
  const ParameterValues plain = small_map({{"bilinear", false}});
  ParameterValues weighted = plain;
  weighted["center_weight"] = 8.0;
  const auto hard = visibility(scene, "hard", small_map({}));
  const double ratio = mean_difference(visibility(scene, "pcf_bilinear", weighted), hard) /
                       mean_difference(visibility(scene, "pcf_bilinear", plain), hard);
  EXPECT_NEAR(ratio, (1.0 / 2.0) / (8.0 / 9.0), 1e-3);
}

}  // namespace
}  // namespace umbrameter

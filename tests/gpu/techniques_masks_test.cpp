// SPDX-License-Identifier: Apache-2.0
// Edge masks: without these a mask could lose penumbrae, or cost as much as filtering everywhere, unseen.

#include "tests/gpu/technique_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

using Picture = std::vector<float>;

ParameterValues small_map(ParameterValues values) {
  values["map_size"] = int64_t{512};
  return values;
}

Picture pcf(const Scene& scene, double width_texels) {
  return visibility(scene, "pcf", small_map({{"filter_width_texels", width_texels}}));
}

Picture hard(const Scene& scene) {
  return visibility(scene, "hard", small_map({}));
}

Picture edge_mask(const Scene& scene, ParameterValues values) {
  return visibility(scene, "edge_mask", small_map(std::move(values)));
}

std::vector<Scene> scenes() {
  return {plate_scene(), half_plane_scene(light_at_4(LightType::sun, 0.5)),
          half_plane_scene(light_at_4(LightType::sphere, 0.5))};
}

size_t differing(const Picture& a, const Picture& b) {
  size_t different = 0;
  for (size_t i = 0; i < a.size(); ++i) different += a[i] != b[i] ? 1 : 0;
  return different;
}

TEST(edge_mask, without_threshold_is_pcf) {
  UMBRAMETER_REQUIRE_GL();
  for (const Scene& scene : scenes()) {
    for (const double width : {0.0, 1.0, 3.0, 7.5}) {
      const auto masked = edge_mask(scene, {{"filter_width_texels", width}, {"threshold", 0.0}});
      EXPECT_EQ(masked, pcf(scene, width)) << scene.name << " " << width;
    }
  }
}

TEST(edge_mask, above_every_step_is_hard) {
  UMBRAMETER_REQUIRE_GL();
  for (const Scene& scene : scenes()) {
    const auto masked =
        edge_mask(scene, {{"filter_width_texels", 7.0}, {"threshold", 1000.0}, {"threshold_unit", "world"}});
    EXPECT_EQ(masked, hard(scene)) << scene.name;
  }
}

TEST(edge_mask, misses_nothing_that_pcf_filters) {
  UMBRAMETER_REQUIRE_GL();
  // Every step of these scenes is far above a tenth of a texel, and a block is as wide as the filter. The widest filter
  // reaches beyond the map, where there is no far side to mark.
  for (const Scene& scene : scenes()) {
    for (const double width : {1.0, 2.0, 3.0, 4.5, 7.0, 16.0, 33.0}) {
      for (const bool far_side_only : {false, true}) {
        if (far_side_only && width > 16.0) continue;
        const auto masked =
            edge_mask(scene, {{"filter_width_texels", width}, {"far_side_only", far_side_only}});
        EXPECT_EQ(masked, pcf(scene, width)) << scene.name << " " << width << " " << far_side_only;
      }
    }
  }
}

TEST(edge_mask, dilated_too_little_misses_the_border_of_penumbrae) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const auto filtered = pcf(scene, 16.0);
  size_t before = 0;
  for (const int64_t extra : {-1, -2, -3}) {
    const size_t missed =
        differing(filtered, edge_mask(scene, {{"filter_width_texels", 16.0}, {"extra_levels", extra}}));
    EXPECT_GT(missed, before) << extra;
    before = missed;
  }
}

/// Floor and an edge 1.5 above it: every step of the map is 1.5 along the axis of this light.
Scene step_scene() {
  return half_plane_scene(light_at_4(LightType::rect, 0.5));
}

bool is_found(const std::string& laplacian, double threshold_world) {
  const Scene scene = step_scene();
  const auto masked = edge_mask(scene, {{"filter_width_texels", 7.0},
                                        {"laplacian", laplacian},
                                        {"threshold", threshold_world},
                                        {"threshold_unit", "world"}});
  return masked == pcf(scene, 7.0);
}

TEST(edge_mask, laplacians_measure_the_height_of_a_straight_step) {
  UMBRAMETER_REQUIRE_GL();
  for (const std::string laplacian : {"four", "eight"}) {
    EXPECT_TRUE(is_found(laplacian, 1.49)) << laplacian;
    EXPECT_FALSE(is_found(laplacian, 1.51)) << laplacian;
  }
  EXPECT_TRUE(is_found("eight_unscaled", 3 * 1.49));
  EXPECT_FALSE(is_found("eight_unscaled", 3 * 1.51));
}

ParameterValues bands(double width_1, double width_2, double width_3, double threshold) {
  return small_map({{"width_1_texels", width_1},
                    {"width_2_texels", width_2},
                    {"width_3_texels", width_3},
                    {"threshold_1", threshold},
                    {"threshold_2", threshold},
                    {"threshold_3", threshold}});
}

TEST(edge_mask_quantised, with_one_width_and_no_thresholds_is_pcf) {
  UMBRAMETER_REQUIRE_GL();
  for (const Scene& scene : scenes()) {
    for (const std::string calibration : {"physical", "stored_depth"}) {
      ParameterValues values = bands(7.0, 7.0, 7.0, 0.0);
      values["calibration"] = calibration;
      EXPECT_EQ(visibility(scene, "edge_mask_quantised", values), pcf(scene, 7.0))
          << scene.name << " " << calibration;
    }
  }
}

TEST(edge_mask_quantised, above_every_step_is_hard) {
  UMBRAMETER_REQUIRE_GL();
  // Depth from 0 to 1 has no step of 10.
  for (const Scene& scene : scenes()) {
    ParameterValues values = bands(3.0, 7.0, 15.0, 10.0);
    values["calibration"] = "stored_depth";
    EXPECT_EQ(visibility(scene, "edge_mask_quantised", values), hard(scene)) << scene.name;
  }
}

constexpr double kWidths[] = {0.0, 3.0, 7.0, 15.0};

/// Band 0 to 3 whose filter the whole picture shows; -1 for none.
int band_shown(const Scene& scene) {
  const auto banded =
      visibility(scene, "edge_mask_quantised", bands(kWidths[1], kWidths[2], kWidths[3], 1.0));
  for (int band = 0; band < 4; ++band) {
    if (banded == pcf(scene, kWidths[band])) return band;
  }
  return -1;
}

TEST(edge_mask_quantised, bands_follow_the_size_of_the_light) {
  UMBRAMETER_REQUIRE_GL();
  int before = 0;
  std::vector<int> bands_seen;
  for (const double size : {0.005, 0.03, 0.08, 0.15, 0.3, 1.0}) {
    const int band = band_shown(half_plane_scene(light_at_4(LightType::sun, size)));
    EXPECT_GE(band, before) << size;
    before = band;
    bands_seen.push_back(band);
  }
  EXPECT_EQ(bands_seen.front(), 0);
  EXPECT_EQ(bands_seen.back(), 3);
}

TEST(edge_mask_quantised, errs_less_over_several_lights_than_any_one_width) {
  UMBRAMETER_REQUIRE_GL();
  double banded = 0.0;
  double single[4] = {};
  for (const double size : {0.1, 0.4, 0.9, 2.0}) {
    const Light light = light_at_4(LightType::sun, size);
    const Scene scene = half_plane_scene(light);
    const auto rmse = [&](const std::string& technique, const ParameterValues& values) {
      return floor_error(render(scene, technique, values),
                         [&](const glm::dvec3& p) { return half_plane_visibility(light, p); })
          .rmse;
    };
    banded += rmse("edge_mask_quantised", bands(kWidths[1], kWidths[2], kWidths[3], 1.0));
    for (int band = 0; band < 4; ++band)
      single[band] += rmse("pcf", small_map({{"filter_width_texels", kWidths[band]}}));
  }
  for (int band = 0; band < 4; ++band) EXPECT_LT(banded, single[band]) << kWidths[band];
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// The techniques against closed forms: without these a wrong penumbra could pass as plausible.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using namespace test;

const ParameterValues kBestPcss = {
    {"map_size", int64_t{4096}}, {"search_taps", int64_t{256}}, {"filter_taps", int64_t{256}}};

ParameterValues accumulate_with(int64_t samples) {
  return {{"map_size", int64_t{1024}}, {"light_samples", samples}};
}

double half_plane_rmse(const Light& light, const std::string& technique, const ParameterValues& parameters) {
  const Frame frame = render(half_plane_scene(light), technique, parameters);
  const ErrorSummary error =
      floor_error(frame, [&](const glm::dvec3& p) { return half_plane_visibility(light, p); });
  EXPECT_GT(error.pixels, 5000u);
  return error.rmse;
}

double plate_rmse(const std::string& technique, const ParameterValues& parameters) {
  const ErrorSummary error = floor_error(render(plate_scene(), technique, parameters), plate_visibility);
  EXPECT_GT(error.pixels, 5000u);
  return error.rmse;
}

TEST(pcss, is_within_001_of_the_half_plane_under_a_square_light) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_LE(half_plane_rmse(light_at_4(LightType::rect, 1.0), "pcss", kBestPcss), 0.01);
}

TEST(pcss, is_within_001_of_the_plate_under_a_rectangular_light) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_LE(plate_rmse("pcss", kBestPcss), 0.01);
}

TEST(pcss, is_within_001_of_the_half_plane_under_disk_sphere_and_sun) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::disk, LightType::sphere, LightType::sun}) {
    EXPECT_LE(half_plane_rmse(light_at_4(type, 1.0), "pcss", kBestPcss), 0.01) << to_text(type);
  }
}

TEST(accumulate, error_falls_with_the_number_of_maps) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::rect, 1.0);
  double before = 1.0;
  for (const int64_t samples : {1, 4, 16, 64}) {
    const double rmse = half_plane_rmse(light, "accumulate", accumulate_with(samples));
    EXPECT_LT(rmse, 0.75 * before) << samples;
    before = rmse;
  }
}

TEST(accumulate, converges_to_the_closed_form) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_LE(half_plane_rmse(light_at_4(LightType::rect, 1.0), "accumulate", accumulate_with(1024)), 0.01);
  EXPECT_LE(plate_rmse("accumulate", accumulate_with(1024)), 0.01);
}

TEST(accumulate, converges_for_disk_and_sun) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_LE(half_plane_rmse(light_at_4(LightType::disk, 1.0), "accumulate", accumulate_with(256)), 0.01);
  EXPECT_LE(half_plane_rmse(light_at_4(LightType::sun, 1.0), "accumulate", accumulate_with(256)), 0.01);
}

TEST(hard, misses_the_penumbra_by_what_a_step_misses) {
  UMBRAMETER_REQUIRE_GL();
  // A ramp of width w against its step errs by |u - step|, rmse sqrt(1/12) inside the ramp, 0 outside.
  const Light light = light_at_4(LightType::rect, 1.0);
  const Frame frame = render(half_plane_scene(light), "hard", {{"map_size", int64_t{4096}}});
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
  const auto step = [&](const glm::dvec3& p) { return p.x > 0 ? 1.0 : 0.0; };
  EXPECT_LE(floor_error(frame, step).rmse, 0.05);
  EXPECT_GT(floor_error(frame, truth).rmse, 0.05);
}

TEST(pcss, averages_agree_on_blockers_at_one_distance) {
  UMBRAMETER_REQUIRE_GL();
  // One blocker distance: both means agree, so the pictures are equal up to the rounding of a mean.
  ParameterValues arithmetic = kBestPcss;
  arithmetic["average"] = std::string("arithmetic");
  EXPECT_NEAR(plate_rmse("pcss", arithmetic), plate_rmse("pcss", kBestPcss), 1e-3);
}

}  // namespace
}  // namespace umbrameter

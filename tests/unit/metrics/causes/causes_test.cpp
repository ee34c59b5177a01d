// SPDX-License-Identifier: Apache-2.0
// Without these a coarse map, a banded filter and a noisy one would look alike.
#include "metrics/causes/causes.h"

#include "core/error.h"
#include "metrics/faults/moire.h"
#include "metrics/image/texel_footprint.h"
#include "tests/unit/metrics/fault_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::add_map;
using testing::box_ramp;
using testing::classify_floor;
using testing::everywhere;
using testing::fault_floor;
using testing::for_floor_rectangle;
using testing::kFloorHeight;
using testing::kFloorPixel;
using testing::kFloorWidth;

Image half_plane(double width = 0.2) {
  return fault_floor([width](double x, double) { return box_ramp(x - 1.0, width); });
}

ErrorCauses causes_of(const Image& test, const Image& reference) {
  const std::vector<uint8_t> mask = everywhere(reference);
  return measure_causes(test, reference, mask, measure_penumbra(test, reference, mask).profiles);
}

TEST(TexelFootprint, IsTheLongerExtentOfATexel) {
  // Columns of the step: texels per pixel. 1/4 texel along x, 1/2 along y: 4 and 2 px.
  EXPECT_DOUBLE_EQ(footprint_px({0.25, 0.0, 0.0, 0.5, true}), 4.0);
  // Sheared by its own width: smaller singular value of [[1, 1], [0, 1]] is (sqrt 5 - 1) / 2.
  EXPECT_NEAR(footprint_px({1.0, 1.0, 0.0, 1.0, true}), 2.0 / (std::sqrt(5.0) - 1.0), 1e-12);
  EXPECT_EQ(footprint_px({1.0, 1.0, 1.0, 1.0, true}), 0.0);  // edge-on: without end
  EXPECT_EQ(footprint_px({}), 0.0);
}

TEST(TexelFootprint, ReadsTheMapAcrossOneSurfaceOnly) {
  Image test = half_plane();
  add_map(test, 3.0);
  const std::vector<uint8_t> mask = everywhere(test);
  SurfaceView surface = checked_surface(test);
  for (const float footprint : footprints_px(checked_texels(test, mask), surface, mask)) {
    ASSERT_NEAR(footprint, 3.0, 1e-3);
  }
  test.plane("primitive_id")[testing::floor_at(10, 10)] = 5.0f;
  test.plane("position.y")[testing::floor_at(10, 10)] = 2.0f;
  const std::vector<float> footprints = footprints_px(checked_texels(test, mask), surface, mask);
  EXPECT_EQ(footprints[testing::floor_at(10, 10)], 0.0f);
  EXPECT_NEAR(footprints[testing::floor_at(9, 10)], 3.0, 1e-3);
}

TEST(Causes, TheTruthHasNoError) {
  const Image reference = half_plane();
  const ErrorCauses causes = causes_of(reference, reference);
  EXPECT_EQ(*causes.mean_abs_error, 0.0);
  EXPECT_EQ(causes.unknown.pixels, reference.pixel_count());
  EXPECT_FALSE(causes.median_footprint_px);
  EXPECT_FALSE(causes.stair_texels);
  EXPECT_EQ(*causes.noise, *causes.reference_noise);
  EXPECT_NEAR(*causes.banding, 0.0, 1e-12);
}

TEST(Causes, FootprintBinsAddUpToTheError) {
  const Image reference = half_plane();
  Image test = half_plane(0.4);
  add_map(test, 3.0);
  for_floor_rectangle(0, 0, 20, kFloorHeight, [&](size_t i) { test.plane("texel_world")[i] = 0.0f; });
  const ErrorCauses causes = causes_of(test, reference);
  EXPECT_NEAR(*causes.median_footprint_px, 3.0, 1e-3);
  EXPECT_EQ(causes.by_footprint[3].pixels, 236u * 128u);  // 2 to 4 px
  EXPECT_EQ(causes.unknown.pixels, 20u * 128u);
  double sum = causes.unknown.mean_abs_error;
  for (const FootprintBin& bin : causes.by_footprint) sum += bin.mean_abs_error;
  EXPECT_NEAR(sum, *causes.mean_abs_error, 1e-15);
  EXPECT_GT(*causes.mean_abs_error, 0.01);
}

TEST(Causes, StairsOfAHardMapAreATwelfthOfATexelSquared) {
  // A soft edge at a slope of .3 whose test jumps from texel row to texel row.
  const double texel = 10.0 * kFloorPixel, slope = 0.3;
  const auto edge = [&](double x, double z) { return box_ramp(z - 0.3 - slope * x, 0.1); };
  const auto stairs = [&](double x, double z) {
    return box_ramp(z - 0.3 - std::floor(slope * x / texel + 0.5) * texel, 0.02);
  };
  Image test = fault_floor(stairs);
  add_map(test, 10.0);
  const ErrorCauses causes = causes_of(test, fault_floor(edge));
  ASSERT_GT(causes.stair_profiles, 20u);
  // Offsets along z are uniform over a texel; along the edge's normal they are shorter by 1 / sqrt(1 + slope^2).
  EXPECT_NEAR(*causes.stair_texels, 1.0 / std::sqrt(12.0) / std::sqrt(1.0 + slope * slope), 0.06);
  // A straight edge, shifted as a whole, has none.
  Image shifted = fault_floor([&](double x, double z) { return edge(x, z + 0.03); });
  add_map(shifted, 10.0);
  EXPECT_NEAR(*causes_of(shifted, fault_floor(edge)).stair_texels, 0.0, 0.01);
}

TEST(Causes, BandingCountsLevels) {
  const auto steps = [](double levels) {
    return [levels](double x, double) { return std::floor(box_ramp(x - 1.0, 0.4) * levels) / levels; };
  };
  const ErrorCauses four = causes_of(fault_floor(steps(4.0)), half_plane(0.4));
  EXPECT_NEAR(*four.levels, 4.0, 1.0);
  // 36 pixels of the 40 lie between .05 and .95.
  EXPECT_NEAR(*four.banding, 1.0 - *four.levels / 36.0, 0.01);
  EXPECT_NEAR(*causes_of(half_plane(0.4), half_plane(0.4)).banding, 0.0, 1e-12);
}

TEST(Causes, NoiseIsThePixelsOwnDeviation) {
  const Image reference = half_plane(1.6);
  Image test = reference;
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0f, 0.03f);
  for (float& v : test.plane("visibility")) v = std::clamp(v + noise(random), 0.0f, 1.0f);
  const ErrorCauses causes = causes_of(test, reference);
  EXPECT_NEAR(*causes.noise, 0.03, 0.0015);
  EXPECT_LT(*causes.reference_noise, 1e-4);
}

TEST(Causes, FewPixelsOfARoughTruthTellNoNoise) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> rough(0.2f, 0.8f);
  Image reference = half_plane(1.6);
  for (float& v : reference.plane("visibility")) v = rough(random);
  EXPECT_TRUE(causes_of(reference, reference).noise);
  // 16 x 16 px: the median of so few is uncertain by .02.
  std::vector<uint8_t> few(reference.pixel_count(), 0);
  for_floor_rectangle(100, 50, 116, 66, [&](size_t i) { few[i] = 1; });
  EXPECT_FALSE(measure_causes(reference, reference, few, {}).reference_noise);
  EXPECT_FALSE(measure_causes(reference, reference, few, {}).noise);
}

TEST(Causes, NothingToMeasureIsNotApplicable) {
  const Image lit = fault_floor([](double, double) { return 1.0; });
  const ErrorCauses causes = causes_of(lit, lit);
  EXPECT_TRUE(causes.mean_abs_error);
  EXPECT_FALSE(causes.noise);
  EXPECT_FALSE(causes.banding);
  const std::vector<uint8_t> nowhere(lit.pixel_count(), 0);
  EXPECT_FALSE(measure_causes(lit, lit, nowhere, {}).mean_abs_error);
}

TEST(Causes, ANanInTheMapNamesItsPixel) {
  Image test = half_plane();
  add_map(test, 3.0);
  test.plane("texel.y")[testing::floor_at(7, 9)] = std::nanf("");
  try {
    causes_of(test, half_plane());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("(7, 9)"), std::string::npos) << error.what();
  }
}

Moire moire_of(const Image& test, const Image& reference) {
  return measure_moire(test, reference, everywhere(reference), classify_floor(test, reference));
}

Image striped(const Image& reference, double period_px, double texel_px) {
  Image test = reference;
  for_floor_rectangle(120, 0, kFloorWidth, kFloorHeight, [&](size_t i) {
    const double x = static_cast<double>(i % kFloorWidth) + 0.5;
    if (x / period_px - std::floor(x / period_px) < 0.5) test.plane("visibility")[i] = 0.4f;
  });
  add_map(test, texel_px);
  return test;
}

TEST(Moire, StripesOfTheMapHaveOneCycleATexel) {
  const Image reference = half_plane();
  const Moire moire = moire_of(striped(reference, 5.3, 5.3), reference);
  ASSERT_TRUE(moire.cycles_per_px && moire.cycles_per_texel);
  EXPECT_NEAR(*moire.cycles_per_px, 1.0 / 5.3, 0.006);
  EXPECT_NEAR(*moire.cycles_per_texel, 1.0, 0.03);
}

TEST(Moire, TexelsUnderTwoPixelsCannotBeCounted) {
  const Image reference = half_plane();
  const Moire moire = moire_of(striped(reference, 5.3, 1.5), reference);
  EXPECT_TRUE(moire.cycles_per_px);
  EXPECT_FALSE(moire.cycles_per_texel);
}

TEST(Moire, SpecklesHaveNoFrequency) {
  const Image reference = half_plane();
  Image test = reference;
  std::mt19937 random(4);
  for_floor_rectangle(120, 0, kFloorWidth, kFloorHeight, [&](size_t i) {
    if (random() % 4 == 0) test.plane("visibility")[i] = 0.4f;
  });
  const Moire moire = moire_of(test, reference);
  EXPECT_EQ(moire.tiles, 0u);
  EXPECT_FALSE(moire.cycles_per_px);
  EXPECT_FALSE(moire_of(reference, reference).cycles_per_px);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these tests a map could show another pixel's answer.

#include "metrics/maps.h"

#include "lab/score.h"
#include "tests/unit/metrics/fault_scene.h"

#include <gtest/gtest.h>

#include <utility>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::fault_floor;

constexpr double kEdge = 1.2, kWidth = 0.3;

Image ramp(double width) {
  Image image = fault_floor([width](double x, double) { return box_ramp(x - kEdge, width); });
  image.add_plane("sample_count", 256.0f);
  return image;
}

Score scored(const Image& test, const Image& reference) {
  ScoreSettings settings;
  settings.maps = true;
  return score_image(test, reference, {1.28, 5.0, 0.64}, settings);
}

TEST(Maps, AreThereOnlyWhenAskedFor) {
  const Image reference = ramp(kWidth);
  EXPECT_FALSE(score_image(reference, reference, {1.28, 5.0, 0.64}).maps);
  const Image maps = *scored(reference, reference).maps;
  for (const char* name : {"z", "fault_class", "width_octaves", "offset_world", "width_known", "flip"})
    EXPECT_TRUE(maps.has(name)) << name;
}

TEST(Maps, ShowTwiceTheWidthAlongThePenumbraAndNothingElsewhere) {
  const Image reference = ramp(kWidth);
  const Image maps = *scored(ramp(2.0 * kWidth), reference).maps;
  const size_t at_edge = testing::floor_at(120, 64), in_light = testing::floor_at(220, 64);
  EXPECT_EQ(maps.plane("width_known")[at_edge], 1.0f);
  EXPECT_NEAR(maps.plane("width_octaves")[at_edge], 1.0f, 0.02f);
  EXPECT_NEAR(maps.plane("offset_world")[at_edge], 0.0f, 0.01f);
  EXPECT_EQ(maps.plane("width_known")[in_light], 0.0f);
  EXPECT_EQ(maps.plane("width_octaves")[in_light], 0.0f);
}

TEST(Maps, SignTheErrorAndNameItsClass) {
  const Image reference = ramp(kWidth);
  Image test = reference;
  const size_t dark = testing::floor_at(220, 64);
  testing::for_floor_rectangle(218, 62, 222, 66, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  const Score score = scored(test, reference);
  EXPECT_LT(score.maps->plane("z")[dark], -3.0f);
  EXPECT_EQ(score.maps->plane("fault_class")[dark], static_cast<float>(FaultClass::acne));
  EXPECT_GT(score.maps->plane("flip")[dark], 0.1f);
  EXPECT_EQ(score.maps->plane("z")[testing::floor_at(250, 10)], 0.0f);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a seam could be hidden by the picture's own edges, or edges be taken for one.

#include "metrics/faults/map_seam.h"

#include "core/error.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

constexpr int kSide = 12;

/// A floor seen from above, one triangle.
Image floor_picture(float visibility) {
  Image image(kSide, kSide);
  for (const char* name : {"position.x", "position.y", "position.z", "normal.x", "normal.z", "primitive_id"})
    image.add_plane(name);
  image.add_plane("normal.y", 1.0f);
  image.add_plane("visibility", visibility);
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    image.plane("position.x")[i] = static_cast<float>(i % kSide);
    image.plane("position.z")[i] = static_cast<float>(i / kSide);
  }
  return image;
}

/// Looked up in map 0 in the upper half, in map 1 below.
Image two_maps(float upper, float lower) {
  Image image = floor_picture(upper);
  const auto map = image.add_plane("map_index");
  const auto v = image.plane("visibility");
  for (size_t i = kSide * kSide / 2; i < v.size(); ++i) map[i] = 1.0f, v[i] = lower;
  return image;
}

const std::vector<uint8_t> kAll(kSide* kSide, 1);

TEST(MapSeam, IsTheStepOfTheErrorBetweenTwoMaps) {
  EXPECT_NEAR(measure_map_seam(two_maps(0.5f, 0.75f), floor_picture(0.5f), kAll).value(), 0.25, 1e-7);
  EXPECT_NEAR(measure_map_seam(two_maps(0.75f, 0.5f), floor_picture(0.5f), kAll).value(), 0.25, 1e-7);
}

TEST(MapSeam, TheTruthsOwnStepIsNone) {
  EXPECT_NEAR(measure_map_seam(two_maps(0.25f, 1.0f), two_maps(0.25f, 1.0f), kAll).value(), 0.0, 1e-7);
  EXPECT_NEAR(measure_map_seam(two_maps(0.25f, 1.0f), two_maps(0.5f, 1.0f), kAll).value(), 0.25, 1e-7);
}

TEST(MapSeam, EdgesThatGoOnOnBothSidesAreNone) {
  // A stair of 0.1 a row: the step across the border is that beside it.
  Image test = two_maps(0.0f, 0.0f);
  for (size_t i = 0; i < test.pixel_count(); ++i)
    test.plane("visibility")[i] = 0.05f * static_cast<float>(i / kSide);
  EXPECT_NEAR(measure_map_seam(test, floor_picture(0.5f), kAll).value(), 0.0, 1e-6);
}

TEST(MapSeam, IsAbsentWithoutABorderThatIsScored) {
  const Image truth = floor_picture(0.5f);
  EXPECT_FALSE(measure_map_seam(floor_picture(0.75f), truth, kAll));  // one map
  std::vector<uint8_t> upper(kSide * kSide, 0);
  std::fill_n(upper.begin(), kSide * kSide / 2, uint8_t{1});
  EXPECT_FALSE(measure_map_seam(two_maps(0.5f, 0.75f), truth, upper));
  Image apart = truth;  // the lower half is another surface, 100 below
  for (size_t i = kSide * kSide / 2; i < apart.pixel_count(); ++i)
    apart.plane("position.y")[i] = -100.0f, apart.plane("primitive_id")[i] = 1.0f;
  EXPECT_FALSE(measure_map_seam(two_maps(0.5f, 0.75f), apart, kAll));
  EXPECT_THROW(measure_map_seam(two_maps(0.5f, 0.75f), truth, {}), Error);
}

}  // namespace
}  // namespace umbrameter

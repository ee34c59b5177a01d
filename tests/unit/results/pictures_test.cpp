// SPDX-License-Identifier: Apache-2.0
// Without these tests a map could lie about its scale.

#include "results/pictures/pictures.h"

#include "tests/support/lab/fakes.h"

#include <gtest/gtest.h>

#include <set>

namespace umbrameter {
namespace {

Rgb8 pixel(const Picture& picture, size_t index) {
  return {picture.rgb[3 * index], picture.rgb[3 * index + 1], picture.rgb[3 * index + 2]};
}

TEST(SignedErrorColour, IsWhiteAtZeroAndFullAtTheEndsOfTheScale) {
  EXPECT_EQ(signed_error_colour(0.0), kNoErrorColour);
  EXPECT_EQ(signed_error_colour(0.25), kTooBrightColour);
  EXPECT_EQ(signed_error_colour(-0.25), kTooDarkColour);
  EXPECT_EQ(signed_error_colour(7.0), kTooBrightColour);  // clipped
}

TEST(SignedErrorColour, IsLinearInBetween) {
  // Half way from white (255, 255, 255) to the red end (190, 10, 30).
  EXPECT_EQ(signed_error_colour(0.125), (Rgb8{223, 133, 143}));
}

TEST(SignedErrorPicture, CountsWhatTheScaleClipsAndLeavesOutWhatIsNotScored) {
  Image test(4, 1);
  Image reference(4, 1);
  auto v = test.add_plane("visibility", 0.5f);
  reference.add_plane("visibility", 0.5f);
  v[1] = 1.0f;
  v[3] = 0.0f;
  const std::vector<uint8_t> mask{1, 1, 1, 0};
  const Picture picture = signed_error_picture(test, reference, mask);
  EXPECT_EQ(pixel(picture, 0), kNoErrorColour);
  EXPECT_EQ(pixel(picture, 1), kTooBrightColour);
  EXPECT_EQ(pixel(picture, 3), kUnscoredColour);
  EXPECT_NEAR(picture.clipped_share, 1.0 / 3.0, 1e-12);
}

TEST(VisibilityPicture, IsGreyInProportionToVisibility) {
  Image image(3, 1);
  auto visibility = image.add_plane("visibility");
  visibility[1] = 0.2f;  // 255 * 0.2 = 51
  visibility[2] = 1.0f;
  const Picture picture = visibility_picture(image);
  EXPECT_EQ(pixel(picture, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(pixel(picture, 1), (Rgb8{51, 51, 51}));
  EXPECT_EQ(pixel(picture, 2), (Rgb8{255, 255, 255}));
}

TEST(VisibilityPicture, ShowsTheBackgroundAsSuch) {
  EXPECT_EQ(pixel(visibility_picture(reference_image()), 0), kBackgroundColour);
}

TEST(FaultLegend, HasOneColourAClassInOrderAndNoneTwice) {
  std::set<Rgb8> colours;
  size_t index = 0;
  for (const FaultLegend& entry : fault_legend()) {
    EXPECT_EQ(static_cast<size_t>(entry.fault), index++);
    colours.insert(entry.colour);
  }
  EXPECT_EQ(index, kFaultClasses);
  EXPECT_EQ(colours.size(), kFaultClasses);
}

TEST(FaultPicture, ShowsEachPixelInTheColourOfItsClass) {
  const std::vector<FaultClass> classes{FaultClass::unscored, FaultClass::acne, FaultClass::explained};
  const Picture picture = fault_picture(classes, 3, 1);
  for (size_t i = 0; i < classes.size(); ++i)
    EXPECT_EQ(pixel(picture, i), fault_legend()[static_cast<size_t>(classes[i])].colour);
}

TEST(ParityLegend, HasOneColourAClassInOrder) {
  size_t index = 0;
  for (const ParityLegend& entry : parity_legend())
    EXPECT_EQ(static_cast<size_t>(entry.parity_class), index++);
  EXPECT_EQ(index, static_cast<size_t>(ParityClass::unknown) + 1);
}

}  // namespace
}  // namespace umbrameter

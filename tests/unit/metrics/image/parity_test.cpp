// SPDX-License-Identifier: Apache-2.0
// Without these, a comparison of two renderers that see different surfaces could be scored.
#include "metrics/image/parity.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

const glm::dvec3 kEye{0.0, 0.0, 0.0};
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// A wall at z = -10 that faces the eye, one primitive, irradiance 2.
Image wall(int width, int height) {
  Image image(width, height);
  for (const char* zero : {"position.x", "position.y", "normal.x", "normal.y"}) image.add_plane(zero, 0.0f);
  image.add_plane("position.z", -10.0f);
  image.add_plane("normal.z", 1.0f);
  image.add_plane("primitive_id", 7.0f);
  image.add_plane("unshadowed_irradiance", 2.0f);
  return image;
}

TEST(Parity, EqualFramesAgreeEverywhere) {
  const Image a = wall(70, 5);
  const Parity parity = compare_surfaces(a, a, kEye);
  EXPECT_EQ(parity.covered, 350u);
  EXPECT_EQ(parity.same_primitive, 350u);
  EXPECT_EQ(parity.agreement, 1.0);
  EXPECT_EQ(parity.median_relative_depth_error, 0.0);
  EXPECT_TRUE(parity.passes);
}

TEST(Parity, AnEmptyFrameAgreesWithAnEmptyFrame) {
  Image a = wall(4, 4);
  for (float& id : a.plane("primitive_id")) id = -1.0f;
  const Parity parity = compare_surfaces(a, a, kEye);
  EXPECT_EQ(parity.covered, 0u);
  EXPECT_EQ(parity.agreement, 1.0);
  EXPECT_EQ(parity.classes[3], ParityClass::background);
}

TEST(Parity, TheSameSurfacesUnderAnotherLightAreToldFromOtherSurfaces) {
  const Image reference = wall(100, 10);
  Image test = reference;
  for (size_t i = 0; i < 900; ++i) test.plane("unshadowed_irradiance")[i] = 1.0f;
  EXPECT_FALSE(compare_surfaces(test, reference, kEye).passes);
  EXPECT_TRUE(compare_surfaces(test, reference, kEye).is_other_light);
  for (size_t i = 0; i < 10; ++i) test.plane("primitive_id")[i] = -1.0f;  // 1 % has no surface
  EXPECT_FALSE(compare_surfaces(test, reference, kEye).is_other_light);
  EXPECT_FALSE(compare_surfaces(reference, reference, kEye).is_other_light);
}

TEST(Parity, EachDisagreementGetsItsOwnClass) {
  const Image reference = wall(10, 1);
  Image test = reference;
  test.plane("primitive_id")[0] = -1.0f;
  test.plane("primitive_id")[1] = 8.0f;  // other primitive, 0.1 / 10 = 1 % deeper: above 1e-3
  test.plane("position.z")[1] = -10.1f;
  test.plane("primitive_id")[2] = 8.0f;  // other primitive, same depth, normal turned by 60 degrees
  test.plane("normal.z")[2] = 0.5f;
  test.plane("normal.x")[2] = std::sqrt(0.75f);
  test.plane("unshadowed_irradiance")[3] = 2.1f;   // 5 %: above 2 %
  test.plane("unshadowed_irradiance")[4] = 2.03f;  // 1.5 %: below
  test.plane("primitive_id")[5] = 8.0f;            // the neighbour triangle of one surface
  test.plane("position.z")[6] = -10.1f;            // the same primitive is the same surface
  const Parity parity = compare_surfaces(test, reference, kEye);
  EXPECT_EQ(parity.classes[0], ParityClass::coverage);
  EXPECT_EQ(parity.classes[1], ParityClass::surface);
  EXPECT_EQ(parity.classes[2], ParityClass::surface);
  EXPECT_EQ(parity.classes[3], ParityClass::irradiance);
  for (const size_t i : {4u, 5u, 6u, 7u, 8u, 9u}) EXPECT_EQ(parity.classes[i], ParityClass::agrees) << i;
  EXPECT_EQ(parity.coverage_mismatch, 1u);
  EXPECT_EQ(parity.surface_mismatch, 2u);
  EXPECT_EQ(parity.irradiance_mismatch, 1u);
  EXPECT_EQ(parity.same_primitive, 6u);
  EXPECT_DOUBLE_EQ(parity.agreement, 0.6);
  EXPECT_FALSE(parity.passes);
}

TEST(Parity, DepthErrorIsRelativeToTheDistanceFromTheEye) {
  const Image reference = wall(3, 3);
  Image test = reference;
  for (float& z : test.plane("position.z")) z = -10.05f;
  const glm::dvec3 eye{0.0, 0.0, 10.0};  // 20 away: 0.05 / 20 = 2.5e-3
  EXPECT_NEAR(compare_surfaces(test, reference, eye).median_relative_depth_error, 2.5e-3, 1e-7);
}

TEST(Parity, PassesAtTheRequiredShareOfCoveredPixels) {
  const Image reference = wall(200, 1);
  Image test = reference;
  test.plane("primitive_id")[0] = -1.0f;  // 199 / 200 = 0.995
  EXPECT_TRUE(compare_surfaces(test, reference, kEye).passes);
  test.plane("primitive_id")[1] = -1.0f;
  EXPECT_FALSE(compare_surfaces(test, reference, kEye).passes);
}

TEST(Parity, IgnoresWhatLiesBehindNothing) {
  const Image reference = wall(3, 1);
  Image test = reference;
  test.plane("primitive_id")[1] = -1.0f;
  test.plane("position.x")[1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(compare_surfaces(test, reference, kEye).coverage_mismatch, 1u);
}

TEST(Parity, NamesThePixelOfANaN) {
  const Image reference = wall(4, 3);
  Image test = reference;
  test.plane("position.y")[4 * 2 + 1] = kNaN;
  try {
    compare_surfaces(test, reference, kEye);
    FAIL() << "a NaN position was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("'position.y' is nan at pixel (1, 2)"), std::string::npos)
        << error.what();
  }
}

TEST(Parity, RejectsOtherSizesAndMissingChannels) {
  const Image reference = wall(4, 3);
  EXPECT_THROW(compare_surfaces(wall(3, 4), reference, kEye), Error);
  Image test = reference;
  test.planes.erase("normal.x");
  EXPECT_THROW(compare_surfaces(test, reference, kEye), Error);
}

TEST(ScoredMask, LeavesOutMismatchesAndPixelsTheLightCannotReach) {
  Image reference = wall(4, 1);
  reference.plane("unshadowed_irradiance")[1] = 0.0f;
  reference.plane("unshadowed_irradiance")[2] = 1e-6f;  // half of 1e-6 of the largest
  Image test = reference;
  test.plane("primitive_id")[3] = -1.0f;
  const Parity parity = compare_surfaces(test, reference, kEye);
  EXPECT_EQ(scored_mask(parity, reference), (std::vector<uint8_t>{1, 0, 0, 0}));
  EXPECT_THROW(scored_mask(parity, wall(1, 4)), Error);
}

TEST(ScoredMask, LeavesOutWhatTheTestPictureDoesNotKnow) {
  const Image reference = wall(4, 1);
  Image test = reference;
  test.add_plane("known", 1.0f);
  test.plane("known")[2] = 0.0f;
  test.plane("position.z")[3] = -20.0f;
  test.plane("primitive_id")[3] = 8.0f;
  const Parity parity = compare_surfaces(test, reference, kEye);
  EXPECT_EQ(parity.classes[2], ParityClass::unknown);
  EXPECT_EQ(parity.unknown, 1u);
  EXPECT_EQ(parity.agreement, 0.75);  // surfaces that agree agree, known or not
  EXPECT_EQ(scored_mask(parity, reference), (std::vector<uint8_t>{1, 1, 0, 0}));
  EXPECT_EQ(known_mask(std::vector<uint8_t>{0, 1, 1, 1}, test), (std::vector<uint8_t>{0, 1, 0, 1}));
  EXPECT_EQ(known_mask(std::vector<uint8_t>{0, 1, 1, 1}, reference), (std::vector<uint8_t>{0, 1, 1, 1}));
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, the second opinion on the lit picture could be of another formula.
#include "metrics/flip/flip.h"

#include "core/error.h"
#include "metrics/flip/flip_color.h"
#include "metrics/image/separable_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbrameter {
namespace {

const ColorChannels kRgb = {"r", "g", "b"};

Image uniform(int width, int height, float r, float g, float b) {
  Image image(width, height);
  image.add_plane("r", r);
  image.add_plane("g", g);
  image.add_plane("b", b);
  return image;
}

TEST(FlipColor, WhiteIsNeutralAndGreyKeepsNoChroma) {
  const glm::vec3 white = hunt_lab_from_linear({1.0f, 1.0f, 1.0f});
  EXPECT_NEAR(white.x, 100.0f, 1e-3f);
  EXPECT_NEAR(white.y, 0.0f, 1e-3f);
  EXPECT_NEAR(white.z, 0.0f, 1e-3f);
  // CIE: relative luminance .184186 is lightness 50.
  EXPECT_NEAR(hunt_lab_from_linear(glm::vec3(0.184186f)).x, 50.0f, 1e-3f);
}

TEST(FlipColor, TheOpponentSpaceIsInvertible) {
  const glm::vec3 color = {0.2f, 0.7f, 0.4f};
  const glm::vec3 back = linear_from_ycxcz(ycxcz_from_linear(color));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], color[k], 1e-5f);
}

TEST(FlipColor, SrgbFollowsItsStandard) {
  EXPECT_FLOAT_EQ(linear_from_srgb(0.04045f), 0.04045f / 12.92f);
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.214041f, 1e-6f);
}

TEST(SeparableFilter, AGaussianKeepsAConstantAndSpreadsAPointAsItself) {
  const Kernel kernel = gaussian_kernel(1.5, 5);
  std::vector<float> plane(20 * 15, 0.0f);
  plane[7 * 20 + 10] = 1.0f;
  const std::vector<float> spread = filter(plane, 20, 15, kernel, kernel);
  EXPECT_FLOAT_EQ(spread[7 * 20 + 12], kernel.weights[5] * kernel.weights[7]);
  EXPECT_FLOAT_EQ(spread[9 * 20 + 10], kernel.weights[5] * kernel.weights[7]);
  const std::vector<float> ones(20 * 15, 1.0f);
  for (const float v : filter(ones, 20, 15, kernel, kernel)) EXPECT_NEAR(v, 1.0f, 1e-6f);
}

TEST(Flip, IsZeroForEqualPictures) {
  const Image a = uniform(40, 30, 0.3f, 0.6f, 0.2f);
  const auto flip = measure_flip(a, a, kRgb);
  EXPECT_EQ(flip->mean, 0.0);
  EXPECT_EQ(flip->p99, 0.0);
}

TEST(Flip, BlackAgainstWhiteIsTheCurveOfTheLightnessDifference) {
  // Flat pictures have no features: FLIP is the colour curve of HyAB = 100 alone. BT.709 in CIELab with the
  // D65 white of the paper: green L 87.735, a -86.183, b 83.180; blue L 32.297, a 79.188, b -107.860; chroma
  // times L / 100: green (-75.61, 72.98), blue (25.58, -34.84); HyAB = 55.44 + sqrt(101.19^2 + 107.82^2) =
  // 203.30; its .7 power 41.28.
  const double largest = std::pow(203.30, 0.7), difference = std::pow(100.0, 0.7);
  const double expected = 0.95 + (difference - 0.4 * largest) / (0.6 * largest) * 0.05;  // .9674
  const auto flip = measure_flip(uniform(40, 30, 0, 0, 0), uniform(40, 30, 1, 1, 1), kRgb);
  EXPECT_NEAR(flip->mean, expected, 1e-4);
  EXPECT_NEAR(flip->p99, expected, 1e-4);
  EXPECT_EQ(flip->share_above_02, 1.0);
}

TEST(Flip, GreenAgainstBlueIsOne) {
  EXPECT_NEAR(measure_flip(uniform(40, 30, 0, 1, 0), uniform(40, 30, 0, 0, 1), kRgb)->mean, 1.0, 1e-5);
}

TEST(Flip, IsSymmetric) {
  std::mt19937 random(3);
  Image a = uniform(64, 48, 0, 0, 0), b = a;
  for (const std::string& channel : kRgb) {
    for (float& v : a.plane(channel)) v = static_cast<float>(random() % 256) / 255.0f;
    for (float& v : b.plane(channel)) v = static_cast<float>(random() % 256) / 255.0f;
  }
  EXPECT_EQ(measure_flip(a, b, kRgb)->mean, measure_flip(b, a, kRgb)->mean);
}

TEST(Flip, AnEdgeIsWorseThanAFlatDifferenceOfItsSize) {
  // The same grey difference, flat and as a line on flat ground: at the line a feature comes on top.
  const Image ground = uniform(64, 64, 0.5f, 0.5f, 0.5f);
  const Image flat = uniform(64, 64, 0.55f, 0.55f, 0.55f);
  Image half = ground;
  for (const std::string& channel : kRgb) {
    for (size_t i = 0; i < half.pixel_count(); ++i) half.plane(channel)[i] = i % 64 < 32 ? 0.5f : 0.55f;
  }
  const float edge = measure_flip(half, ground, kRgb)->map[32 * 64 + 34];
  EXPECT_GT(edge, measure_flip(flat, ground, kRgb)->map[32 * 64 + 34]);
}

TEST(Flip, FinerDetailIsSeenLessFromFurther) {
  Image a = uniform(64, 64, 0.5f, 0.5f, 0.5f), b = a;
  for (const std::string& channel : kRgb) {
    for (size_t i = 0; i < a.pixel_count(); ++i) a.plane(channel)[i] = (i + i / 64) % 2 == 0 ? 0.4f : 0.6f;
  }
  EXPECT_LT(measure_flip(a, b, kRgb, {120.0})->mean, 0.5 * measure_flip(a, b, kRgb, {20.0})->mean);
}

Image noise(int width, int height, uint64_t seed, bool is_grey) {
  std::mt19937_64 random(seed);
  Image image = uniform(width, height, 0, 0, 0);
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const float first = static_cast<float>(random() % 256) / 255.0f;
    image.plane("r")[i] = first;
    for (const char* other : {"g", "b"})
      image.plane(other)[i] = is_grey ? first : static_cast<float>(random() % 256) / 255.0f;
  }
  return image;
}

// But for the roundings that three channels leave in the chroma.
TEST(Flip, OfGreyIsThatOfThreeEqualChannels) {
  constexpr float kTolerance = 5e-5f;
  const Image a = noise(150, 90, 1, true), b = noise(150, 90, 2, true);
  const auto color = measure_flip(a, b, kRgb), grey = measure_flip(a, b, {"g", "g", "g"});
  for (size_t i = 0; i < color->map.size(); ++i) ASSERT_NEAR(grey->map[i], color->map[i], kTolerance) << i;
  const auto hdr_color = measure_hdr_flip(a, b, kRgb), hdr_grey = measure_hdr_flip(a, b, {"g", "g", "g"});
  for (size_t i = 0; i < color->map.size(); ++i)
    ASSERT_NEAR(hdr_grey->map[i], hdr_color->map[i], kTolerance) << i;
}

TEST(Flip, AReferenceServesManyTests) {
  const Image truth = noise(150, 90, 1, false);
  const FlipReference reference(truth, kRgb);
  const HdrFlipReference hdr_reference(truth, kRgb);
  for (const uint64_t seed : {2u, 3u}) {
    const Image test = noise(150, 90, seed, false);
    EXPECT_EQ(reference.measure(test)->map, measure_flip(test, truth, kRgb)->map);
    EXPECT_EQ(hdr_reference.measure(test)->map, measure_hdr_flip(test, truth, kRgb)->map);
  }
  EXPECT_THROW(reference.measure(noise(90, 150, 2, false)), Error);
}

TEST(Flip, RejectsValuesTheDisplayHasNot) {
  Image bad = uniform(8, 8, 0.5f, 0.5f, 0.5f);
  bad.plane("g")[9] = 1.5f;
  try {
    measure_flip(bad, uniform(8, 8, 0, 0, 0), kRgb);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'g' is 1.5 at pixel (1, 1)"), std::string::npos)
        << error.what();
  }
}

TEST(Flip, AnEmptyPictureIsNotApplicable) {
  EXPECT_FALSE(measure_flip(uniform(0, 0, 0, 0, 0), uniform(0, 0, 0, 0, 0), kRgb));
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, the exposures of HDR-FLIP, or the roots and powers under FLIP, could be others than written.
#include "core/error.h"
#include "core/statistics.h"
#include "metrics/flip/flip.h"
#include "metrics/flip/flip_color.h"
#include "metrics/image/vector_math.h"

#include <gtest/gtest.h>

#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <random>

namespace umbrameter {
namespace {

const ColorChannels kGrey = {"y", "y", "y"};

Image grey(int width, int height, float value) {
  Image image(width, height);
  image.add_plane("y", value);
  return image;
}

Image noise(int width, int height, float scale, uint64_t seed) {
  Image image = grey(width, height, 0.0f);
  std::mt19937_64 random(seed);
  for (float& v : image.plane("y")) v = scale * static_cast<float>(1 + random() % 4096) / 4096.0f;
  return image;
}

TEST(VectorMath, RootsAndPowersAreWithinAFewRoundings) {
  for (double x = 1e-12; x < 1e3; x *= 1.0137) {
    const float f = static_cast<float>(x);
    EXPECT_NEAR(root<3>(f), std::cbrt(static_cast<double>(f)), 4e-7 * std::cbrt(x));
    EXPECT_NEAR(root<5>(f), std::pow(static_cast<double>(f), 0.2), 4e-7 * std::pow(x, 0.2));
  }
  for (double x = 1e-8; x <= 1.0; x *= 1.0537) {
    for (const float y : {0.0f, 0.1f, 0.5f, 0.77f, 1.0f}) {
      EXPECT_NEAR(fast_pow(static_cast<float>(x), y), std::pow(static_cast<float>(x), y), 2e-7)
          << x << " " << y;
    }
  }
  EXPECT_EQ(root<5>(0.0f), 0.0f);
  EXPECT_EQ(fast_pow(0.0f, 0.5f), 0.0f);
  EXPECT_EQ(fast_pow(0.0f, 0.0f), 1.0f);
}

TEST(Median, IsTheMiddleOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median(std::vector<float>{3.0f, 1.0f, 2.0f}), 2.0);
  EXPECT_EQ(median(std::vector<double>{4.0, 1.0, 2.0, 100.0}), 3.0);
}

TEST(HdrFlip, TheRangeRunsFromTheBrightestToTheMedian) {
  // The curve reaches .85 at x: (.9036 - .74358) x^2 + (.018 - .3009) x - .119 = 0, x = 2.1189.
  EXPECT_NEAR(aces_tone(2.1189f), 0.85f, 1e-4f);
  Image image = grey(9, 1, 0.5f);
  image.plane("y")[4] = 16.0f;
  const auto range = exposure_range(image, kGrey);
  EXPECT_NEAR(range->start, std::log2(2.1189 / 16.0), 1e-3);
  EXPECT_NEAR(range->stop, std::log2(2.1189 / 0.5), 1e-3);
  EXPECT_EQ(range->count, 5);  // five stops
  EXPECT_EQ(exposure_range(grey(4, 4, 3.0f), kGrey)->count, 2);
}

TEST(HdrFlip, BlackAgainstGreyIsTheCurveOfTheExposedLightness) {
  // Flat: the reference is exposed to .85, lightness 116 * .85^(1/3) - 16 = 93.884. Curve as in flip_test.
  const double largest = std::pow(203.30, 0.7), difference = std::pow(93.884, 0.7);
  const double expected = 0.95 + (difference - 0.4 * largest) / (0.6 * largest) * 0.05;
  EXPECT_NEAR(measure_hdr_flip(grey(40, 30, 0.0f), grey(40, 30, 7.0f), kGrey)->mean, expected, 1e-4);
}

TEST(HdrFlip, IsZeroForEqualPicturesAndBlindToACommonExposure) {
  const Image a = noise(40, 30, 8.0f, 1), b = noise(40, 30, 8.0f, 2);
  EXPECT_EQ(measure_hdr_flip(a, a, kGrey)->mean, 0.0);
  const double once = measure_hdr_flip(a, b, kGrey)->mean;
  EXPECT_NEAR(measure_hdr_flip(noise(40, 30, 64.0f, 1), noise(40, 30, 64.0f, 2), kGrey)->mean, once, 1e-6);
}

TEST(HdrFlip, TheRangeIsTheReferencesSoTheOperandsAreNotEqual) {
  const Image dim = noise(40, 30, 1.0f, 1);
  Image glint = dim;
  glint.plane("y")[600] = 500.0f;
  EXPECT_GT(std::abs(measure_hdr_flip(dim, glint, kGrey)->mean - measure_hdr_flip(glint, dim, kGrey)->mean),
            1e-5);
}

TEST(HdrFlip, SeesInTheDarkWhatOneExposureHides) {
  // A sun sets the first exposure; the shadows' difference shows at the last.
  Image a = grey(64, 64, 0.01f), b = a;
  for (size_t i = 0; i < 64; ++i) a.plane("y")[i] = b.plane("y")[i] = 1000.0f;
  for (size_t i = 64 * 40; i < 64 * 44; ++i) b.plane("y")[i] = 0.02f;
  EXPECT_GT(measure_hdr_flip(b, a, kGrey)->map[42 * 64 + 32], 0.1f);
}

TEST(HdrFlip, ABlackReferenceOrAnEmptyPictureIsNotApplicable) {
  EXPECT_FALSE(measure_hdr_flip(grey(8, 8, 1.0f), grey(8, 8, 0.0f), kGrey));
  EXPECT_FALSE(measure_hdr_flip(grey(0, 0, 0.0f), grey(0, 0, 0.0f), kGrey));
}

TEST(HdrFlip, NamesTheBadPixel) {
  Image bad = grey(8, 8, 0.5f);
  bad.plane("y")[17] = std::numeric_limits<float>::infinity();
  try {
    measure_hdr_flip(bad, grey(8, 8, 1.0f), kGrey);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'y' is inf at pixel (1, 2)"), std::string::npos)
        << error.what();
  }
}

TEST(Flip, BandsAndTilesLeaveNoSeam) {
  // Wider than a tile and higher than a band; a shift of both pictures moves the map along with it.
  const auto shifted = [](const Image& image, size_t by) {
    Image out(image.width - 40, image.height - 40);
    const std::span<float> to = out.add_plane("y");
    for (size_t y = 0; y < static_cast<size_t>(out.height); ++y) {
      for (size_t x = 0; x < static_cast<size_t>(out.width); ++x) {
        to[y * static_cast<size_t>(out.width) + x] =
            image.plane("y")[(y + by) * static_cast<size_t>(image.width) + x + by];
      }
    }
    return out;
  };
  const Image a = noise(340, 260, 1.0f, 1), b = noise(340, 260, 1.0f, 2);
  const auto first = measure_flip(shifted(a, 3), shifted(b, 3), kGrey);
  const auto second = measure_flip(shifted(a, 20), shifted(b, 20), kGrey);
  for (size_t y = 12; y < 190; ++y) {
    for (size_t x = 12; x < 270; ++x) {
      ASSERT_EQ(first->map[(y + 17) * 300 + x + 17], second->map[y * 300 + x]) << x << ", " << y;
    }
  }
}

TEST(Flip, SameBitsWithAnyThreadCount) {
  const Image a = noise(300, 200, 1.0f, 1), b = noise(300, 200, 1.0f, 2);
  const auto many = measure_flip(a, b, kGrey);
  oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(measure_flip(a, b, kGrey)->map, many->map);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, an error could come from the reference's own noise, or an interval could promise too much.
#include "metrics/error/visibility_error.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace umbrameter {
namespace {

std::vector<uint8_t> everywhere(const Image& image) {
  return std::vector<uint8_t>(image.pixel_count(), 1);
}

Image test_image(int width, int height, float visibility) {
  Image image(width, height);
  image.add_plane("visibility", visibility);
  return image;
}

Image exact_reference(int width, int height, float visibility) {
  Image image = test_image(width, height, visibility);
  image.add_plane("half_a", visibility);
  image.add_plane("half_b", visibility);
  image.add_plane("visibility_se", 0.0f);
  return image;
}

void set_reference(Image& reference, size_t i, float value) {
  for (const char* channel : {"visibility", "half_a", "half_b"}) reference.plane(channel)[i] = value;
}

// Truth 0.5 everywhere; halves carry independent normal noise, the mean of both half the variance.
struct Noise {
  double sigma_half = 0.05;
  bool same_half_twice = false;  // the mutant: noise of the halves is one and the same
};

Image noisy_reference(int width, int height, const Noise& noise, std::mt19937_64& random) {
  Image reference = exact_reference(width, height, 0.5f);
  std::normal_distribution<double> normal(0.0, noise.sigma_half);
  for (size_t i = 0; i < reference.pixel_count(); ++i) {
    const double a = normal(random);
    const double b = noise.same_half_twice ? a : normal(random);
    reference.plane("half_a")[i] = static_cast<float>(0.5 + a);
    reference.plane("half_b")[i] = static_cast<float>(0.5 + b);
    reference.plane("visibility")[i] = static_cast<float>(0.5 + 0.5 * (a + b));
    reference.plane("visibility_se")[i] = static_cast<float>(noise.sigma_half / std::sqrt(2.0));
  }
  return reference;
}

// An error field that is constant over 8 x 8 px blocks, normal with standard deviation `sigma`: a filter's
// reach.
Image blockwise_wrong(int width, int height, double sigma, std::mt19937_64& random) {
  Image test = test_image(width, height, 0.5f);
  std::normal_distribution<double> normal(0.0, sigma);
  const std::span<float> v = test.plane("visibility");
  for (int y = 0; y < height; y += 8) {
    for (int x = 0; x < width; x += 8) {
      const float value = static_cast<float>(0.5 + normal(random));
      for (int k = 0; k < 64; ++k) v[static_cast<size_t>((y + k / 8) * width + x + k % 8)] = value;
    }
  }
  return test;
}

// Share of `trials` whose interval holds the expected mse sigma_test^2.
double coverage(int trials, double sigma_test, const Noise& noise) {
  VisibilityErrorSettings settings;
  settings.bootstrap_rounds = 400;
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::mt19937_64 random(static_cast<uint64_t>(trial) + 1);
    const Image test = blockwise_wrong(256, 128, sigma_test, random);
    const Image reference = noisy_reference(256, 128, noise, random);
    const VisibilityError error = measure_visibility_error(test, reference, everywhere(test), settings);
    const double expected = sigma_test * sigma_test;
    if (error.mse->low <= expected && expected <= error.mse->high) ++held;
  }
  return static_cast<double>(held) / trials;
}

TEST(VisibilityError, IsZeroForTheNoiseFreeTruth) {
  const Image reference = exact_reference(40, 40, 0.3f);
  const VisibilityError error = measure_visibility_error(reference, reference, everywhere(reference));
  EXPECT_EQ(error.scored_pixels, 1600u);
  EXPECT_EQ(error.mse->value, 0.0);
  EXPECT_EQ(error.rmse->high, 0.0);
  EXPECT_EQ(*error.mae, 0.0);
  EXPECT_EQ(*error.bias, 0.0);
  EXPECT_EQ(*error.max_error, 0.0);
  EXPECT_EQ(*error.noise_floor_mse, 0.0);
}

TEST(VisibilityError, SeparatesOverFromUnderShadowing) {
  Image test = test_image(64, 1, 0.5f);
  const Image reference = exact_reference(64, 1, 0.5f);
  test.plane("visibility")[0] = 0.25f;  // 0.25 too dark
  test.plane("visibility")[1] = 1.0f;   // 0.5 too bright
  const VisibilityError error = measure_visibility_error(test, reference, everywhere(test));
  EXPECT_DOUBLE_EQ(*error.over_shadowing, 0.25 / 64);
  EXPECT_DOUBLE_EQ(*error.under_shadowing, 0.5 / 64);
  EXPECT_DOUBLE_EQ(*error.mae, 0.75 / 64);
  EXPECT_DOUBLE_EQ(*error.bias, 0.25 / 64);
  EXPECT_DOUBLE_EQ(error.mse->value, (0.0625 + 0.25) / 64);
  EXPECT_DOUBLE_EQ(error.rmse->value, std::sqrt(0.3125 / 64));
  EXPECT_DOUBLE_EQ(*error.max_error, 0.5);
}

TEST(VisibilityError, SwappingTheOperandsSwapsTheSignOfTheBias) {
  const Image bright = exact_reference(8, 8, 0.75f);
  const Image dark = exact_reference(8, 8, 0.5f);
  EXPECT_EQ(*measure_visibility_error(bright, dark, everywhere(dark)).bias, 0.25);
  EXPECT_EQ(*measure_visibility_error(dark, bright, everywhere(dark)).bias, -0.25);
}

TEST(VisibilityError, RegionsAddUpToTheTotal) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  Image test = test_image(131, 77, 0.0f);
  Image reference = exact_reference(131, 77, 0.0f);
  for (size_t i = 0; i < test.pixel_count(); ++i) {
    test.plane("visibility")[i] = uniform(random);
    const float truth = std::min(1.0f, std::max(0.0f, 1.5f * uniform(random) - 0.25f));
    set_reference(reference, i, truth);
  }
  const VisibilityError error = measure_visibility_error(test, reference, everywhere(test));
  double mse = 0.0, bias = 0.0, share = 0.0;
  for (const RegionError* region : {&error.lit, &error.umbra, &error.penumbra}) {
    EXPECT_GT(region->pixels, 500u);
    mse += region->share * region->mse;
    bias += region->share * region->bias;
    share += region->share;
  }
  EXPECT_NEAR(share, 1.0, 1e-12);
  EXPECT_NEAR(mse, error.mse->value, 1e-12);
  EXPECT_NEAR(bias, *error.bias, 1e-12);
}

TEST(VisibilityError, RegionsAreSplitByTheReference) {
  Image reference = exact_reference(4, 1, 0.5f);
  set_reference(reference, 0, 0.995f);
  set_reference(reference, 1, 0.985f);
  set_reference(reference, 2, 0.005f);
  const VisibilityError error =
      measure_visibility_error(test_image(4, 1, 0.0f), reference, std::vector<uint8_t>(4, 1));
  EXPECT_EQ(error.lit.pixels, 1u);
  EXPECT_EQ(error.umbra.pixels, 1u);
  EXPECT_EQ(error.penumbra.pixels, 2u);
}

TEST(VisibilityError, AnEmptyMaskIsNotApplicable) {
  const Image reference = exact_reference(8, 8, 0.3f);
  const VisibilityError error = measure_visibility_error(reference, reference, std::vector<uint8_t>(64, 0));
  EXPECT_EQ(error.scored_pixels, 0u);
  EXPECT_FALSE(error.mse || error.rmse || error.mae || error.bias || error.over_shadowing ||
               error.under_shadowing || error.noise_floor_mse || error.max_error);
}

TEST(VisibilityError, MaskedPixelsDoNotCount) {
  Image test = test_image(64, 2, 0.5f);
  const Image reference = exact_reference(64, 2, 0.5f);
  std::vector<uint8_t> mask = everywhere(test);
  test.plane("visibility")[70] = std::numeric_limits<float>::quiet_NaN();
  mask[70] = 0;
  EXPECT_EQ(*measure_visibility_error(test, reference, mask).max_error, 0.0);
}

void expect_input_error(const Image& test, const Image& reference, const std::string& part) {
  try {
    measure_visibility_error(test, reference, everywhere(test));
    FAIL() << "expected an error saying: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(VisibilityError, NamesThePixelOfANaNOrOfAValueOutOfRange) {
  const Image good = exact_reference(9, 4, 0.5f);
  Image bad = good;
  bad.plane("visibility")[9 * 3 + 2] = std::numeric_limits<float>::quiet_NaN();
  expect_input_error(bad, good, "'visibility' is nan at pixel (2, 3)");
  bad = good;
  bad.plane("visibility")[9 * 1 + 4] = 1.01f;
  expect_input_error(bad, good, "'visibility' is 1.01 at pixel (4, 1)");
  bad = good;
  bad.plane("half_b")[0] = -0.5f;
  expect_input_error(good, bad, "'half_b' is -0.5 at pixel (0, 0)");
  bad = good;
  bad.plane("visibility_se")[35] = std::numeric_limits<float>::infinity();
  expect_input_error(good, bad, "'visibility_se' is inf at pixel (8, 3)");
}

TEST(VisibilityError, RejectsOtherSizesAndMissingChannels) {
  const Image reference = exact_reference(8, 4, 0.5f);
  expect_input_error(test_image(4, 8, 0.5f), reference, "4x8 against 8x4");
  expect_input_error(test_image(8, 4, 0.5f), test_image(8, 4, 0.5f), "half_a");
  EXPECT_THROW(measure_visibility_error(reference, reference, std::vector<uint8_t>(31, 1)), Error);
}

TEST(VisibilityError, NoiseOfTheReferenceIsNotBlamedOnTheTest) {
  std::mt19937_64 random(3);
  const Image test = test_image(512, 512, 0.5f);
  const Image reference = noisy_reference(512, 512, {}, random);
  const VisibilityError error = measure_visibility_error(test, reference, everywhere(test));
  // Products of two independent normals: sd 0.05^2 / sqrt(512^2) = 4.9e-6.
  EXPECT_NEAR(error.mse->value, 0.0, 4 * 4.9e-6);
  EXPECT_LT(error.mse->low, 0.0);
  EXPECT_GT(error.mse->high, 0.0);
  EXPECT_NEAR(*error.noise_floor_mse, 0.00125, 1e-8);
  // What cannot be debiased: E|noise| = sigma sqrt(2/pi).
  EXPECT_NEAR(*error.mae, 0.05 / std::sqrt(2.0) * std::sqrt(2.0 / std::numbers::pi), 3e-4);
}

TEST(VisibilityError, IntervalHoldsTheKnownErrorInNineteenOfTwentyTrials) {
  // 200 trials: sd of the share is sqrt(.95 * .05 / 200) = 1.5 %; allow 3 sd and 1.5 % for 32 tiles'
  // skewness.
  const double share = coverage(200, 0.08, {});
  EXPECT_GT(share, 0.89);
  EXPECT_LT(share, 0.995);
}

TEST(VisibilityError, HalvesThatShareTheirNoiseAreCaughtByTheCoverage) {
  // Adds sigma_half^2 = 0.0025 to an expected 0.0064, some ten standard errors.
  EXPECT_LT(coverage(40, 0.08, {.same_half_twice = true}), 0.1);
}

TEST(VisibilityError, ASingleTileKnowsNothingOfItsSpread) {
  const VisibilityError error = measure_visibility_error(
      test_image(16, 16, 0.5f), exact_reference(16, 16, 0.25f), everywhere(Image(16, 16)));
  EXPECT_DOUBLE_EQ(error.mse->value, 0.0625);
  EXPECT_EQ(error.mse->low, -1.0);
  EXPECT_EQ(error.mse->high, 1.0);
}

TEST(VisibilityError, SameBitsWithAnyThreadCount) {
  std::mt19937_64 random(9);
  const Image test = blockwise_wrong(256, 256, 0.1, random);
  const Image reference = noisy_reference(256, 256, {}, random);
  const VisibilityError many = measure_visibility_error(test, reference, everywhere(test));
  oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const VisibilityError single = measure_visibility_error(test, reference, everywhere(test));
  EXPECT_EQ(many.mse->value, single.mse->value);
  EXPECT_EQ(many.mse->low, single.mse->low);
  EXPECT_EQ(many.mse->high, single.mse->high);
  EXPECT_EQ(*many.mae, *single.mae);
}

TEST(VisibilityError, ASeedGivesOneIntervalAndAnotherSeedAnother) {
  std::mt19937_64 random(9);
  const Image test = blockwise_wrong(128, 128, 0.1, random);
  const Image reference = noisy_reference(128, 128, {}, random);
  const auto low = [&](uint64_t seed) {
    return measure_visibility_error(test, reference, everywhere(test), {.seed = seed}).mse->low;
  };
  EXPECT_EQ(low(1), low(1));
  EXPECT_NE(low(1), low(2));
}

}  // namespace
}  // namespace umbrameter

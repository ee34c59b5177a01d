// SPDX-License-Identifier: Apache-2.0
// Without these, noise could be called a fault, or a fault noise.
#include "metrics/statistics/significance.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace umbrameter {
namespace {

constexpr int kReplicates = 8;

std::vector<uint8_t> everywhere(const Image& image) {
  return std::vector<uint8_t>(image.pixel_count(), 1);
}

Image constant(int width, int height, float visibility) {
  Image image(width, height);
  image.add_plane("visibility", visibility);
  return image;
}

// Truth .5 as the reference measures it: the mean of eight replicates and its standard error from their spread.
Image noisy_half(int width, int height, double se, uint64_t seed) {
  Image image = constant(width, height, 0.5f);
  image.add_plane("visibility_se");
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, se * std::sqrt(kReplicates));
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < kReplicates; ++k) {
      const double value = noise(random);
      sum += value;
      squares += value * value;
    }
    const double mean = sum / kReplicates, spread = squares - kReplicates * mean * mean;
    image.plane("visibility")[i] = static_cast<float>(0.5 + mean);
    image.plane("visibility_se")[i] =
        static_cast<float>(std::sqrt(spread / (kReplicates * (kReplicates - 1))));
  }
  return image;
}

// `wrong_share` of the pixels, in the upper rows, brighter by `error`.
Image partly_wrong(int width, int height, double wrong_share, float error) {
  Image image = constant(width, height, 0.5f);
  const size_t count = static_cast<size_t>(wrong_share * static_cast<double>(image.pixel_count()));
  for (size_t i = 0; i < count; ++i) image.plane("visibility")[i] += error;
  return image;
}

TEST(NormalDeviate, TakesStudentToTheNormal) {
  // Two-sided 5 %, 1 % and .1 % of Student's t with 7 degrees are 2.3646, 3.4995 and 5.4079; of the normal
  // 1.95996, 2.57583 and 3.29053.
  SignificanceSettings settings;
  settings.floor_variance = 1e-12;
  const auto z = [&](double t) { return normal_deviate(0.5 + 0.01 * t, 0.5, 0.01, 0.0, settings); };
  // Wallace's transformation is .1, .2 and .4 % too small there.
  EXPECT_NEAR(z(2.3646), 1.95996, 0.002 * 1.95996);
  EXPECT_NEAR(z(3.4995), 2.57583, 0.003 * 2.57583);
  EXPECT_NEAR(z(5.4079), 3.29053, 0.005 * 3.29053);
  EXPECT_DOUBLE_EQ(z(-3.0), -z(3.0));
}

TEST(NormalDeviate, IsTheFloorsWhereTheReferenceIsExact) {
  EXPECT_DOUBLE_EQ(normal_deviate(0.002, 0.0, 0.0, 0.0, {}), 2.0);
}

TEST(NormalDeviate, JudgesASaturatedPixelByTheSamplesThatAgreed) {
  // No hit in 1024 samples, se = .5 / 1024. Wilson's interval at z ends at z^2 / (n + z^2): .0037370 for z = 1.96;
  // the floor alone would call that 7 sigmas. The rule of three, 3 / n, is one-sided 95 %: 1.73.
  SignificanceSettings settings;
  settings.floor_variance = 1e-12;
  const double se = 0.5 / 1024;
  EXPECT_NEAR(normal_deviate(1.96 * 1.96 / (1024 + 1.96 * 1.96), 0.0, se, 0.0, settings), 1.96, 1e-3);
  EXPECT_NEAR(normal_deviate(3.0 / 1024, 0.0, se, 0.0, settings), std::sqrt(3.0), 0.01);
  EXPECT_NEAR(normal_deviate(1.0 - 3.0 / 1024, 1.0, se, 0.0, settings), -std::sqrt(3.0), 0.01);
  EXPECT_GT(normal_deviate(0.1, 0.0, se, 0.0, settings), 10.0);
  EXPECT_EQ(normal_deviate(1.0, 1.0, se, 0.0, settings), 0.0);
}

TEST(Significance, OfTheTruthItselfIsNothing) {
  const Image reference = noisy_half(64, 64, 0.01, 1);
  const Significance out = measure_significance(reference, reference, everywhere(reference));
  EXPECT_EQ(out.tested, 4096u);
  EXPECT_EQ(out.significant(), 0u);
  EXPECT_FALSE(out.threshold_z);
  EXPECT_EQ(out.exceeding, 0u);
}

TEST(Significance, CallsNoneWrongInNineteenOfTwentyImagesOfTheTruth) {
  // With every pixel right a false discovery is any discovery: at most 5 % of images; 300 trials, sd 1.3 %.
  int with_any = 0;
  double exceeding = 0.0, expected = 0.0;
  const Image test = constant(48, 48, 0.5f);
  for (uint64_t trial = 1; trial <= 300; ++trial) {
    const Significance out = measure_significance(test, noisy_half(48, 48, 0.02, trial), everywhere(test));
    with_any += out.significant() > 0 ? 1 : 0;
    exceeding += static_cast<double>(out.exceeding);
    expected += *out.expected_exceeding;
  }
  EXPECT_LT(with_any / 300.0, 0.05 + 3 * 0.013);
  EXPECT_GT(with_any, 0);                                     // not by never calling any
  EXPECT_NEAR(exceeding, expected, 4 * std::sqrt(expected));  // 1866 of 691200
}

TEST(Significance, TakenForNormalTheSameNoiseIsCalledWrong) {
  // The mutant: without Student's tails. Of 2304 pixels some exceed five standard errors in every image.
  SignificanceSettings settings;
  settings.replicates = 100000;
  const Image test = constant(48, 48, 0.5f);
  int with_any = 0;
  for (uint64_t trial = 1; trial <= 20; ++trial) {
    const Image reference = noisy_half(48, 48, 0.02, trial);
    with_any += measure_significance(test, reference, everywhere(test), settings).significant() > 0 ? 1 : 0;
  }
  EXPECT_GT(with_any, 15);
}

TEST(Significance, KeepsTheShareOfFalseOnesAmongTheWrong) {
  const Image test = partly_wrong(64, 64, 0.25, 0.1f);
  double false_share = 0.0;
  for (uint64_t trial = 1; trial <= 60; ++trial) {
    const Significance out = measure_significance(test, noisy_half(64, 64, 0.01, trial), everywhere(test));
    size_t false_ones = 0;
    for (size_t i = 1024; i < 4096; ++i) false_ones += out.wrong[i];
    EXPECT_GT(out.significant() - false_ones, 1000u);
    false_share += static_cast<double>(false_ones) / static_cast<double>(out.significant()) / 60;
  }
  EXPECT_LT(false_share, 0.05);
  EXPECT_GT(false_share, 0.02);  // 3/4 of .05 by theory: not by calling too few
}

TEST(Significance, FindsMoreWithMoreSamples) {
  // 1024 pixels wrong by two, four and eight standard errors: four times the samples each.
  const Image test = partly_wrong(64, 64, 0.25, 0.06f);
  const auto found = [&](double se) {
    return measure_significance(test, noisy_half(64, 64, se, 7), everywhere(test)).significant();
  };
  EXPECT_LT(found(0.03), 300u);
  EXPECT_GT(found(0.015), 400u);
  EXPECT_GT(found(0.0075), 900u);
}

TEST(Significance, SignsFollowTheOperands) {
  const Image bright = noisy_half(32, 32, 0.001, 3);
  Image dark = bright;
  for (float& v : dark.plane("visibility")) v -= 0.1f;
  const Significance out = measure_significance(dark, bright, everywhere(bright));
  EXPECT_EQ(out.too_dark, 1024u);
  EXPECT_EQ(measure_significance(bright, dark, everywhere(bright)).too_bright, 1024u);
}

TEST(Significance, ANoisyTestCountsItsOwnNoise) {
  const Image reference = noisy_half(48, 48, 0.01, 1);
  const Image test = noisy_half(48, 48, 0.03, 2);
  const Significance out = measure_significance(test, reference, everywhere(test));
  EXPECT_LT(*out.exceedance_sigmas, 4.0);
  Image silent = test;
  silent.planes.erase("visibility_se");
  EXPECT_GT(*measure_significance(silent, reference, everywhere(test)).exceedance_sigmas, 50.0);
}

TEST(Significance, AnEmptyMaskIsNotApplicable) {
  const Image reference = noisy_half(8, 8, 0.01, 1);
  const Significance out = measure_significance(reference, reference, std::vector<uint8_t>(64, 0));
  EXPECT_EQ(out.tested, 0u);
  EXPECT_FALSE(out.expected_exceeding || out.exceedance_sigmas || out.threshold_z);
}

TEST(Significance, NamesTheBadPixelAndRejectsOtherSizes) {
  const Image reference = noisy_half(9, 4, 0.01, 1);
  Image bad = reference;
  bad.plane("visibility_se")[9 * 2 + 5] = std::numeric_limits<float>::quiet_NaN();
  try {
    measure_significance(constant(9, 4, 0.5f), bad, everywhere(bad));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'visibility_se' is nan at pixel (5, 2)"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(measure_significance(constant(4, 9, 0.5f), reference, everywhere(reference)), Error);
  EXPECT_THROW(measure_significance(reference, reference, std::vector<uint8_t>(5, 1)), Error);
}

}  // namespace
}  // namespace umbrameter

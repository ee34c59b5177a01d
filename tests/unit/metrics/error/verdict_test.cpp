// SPDX-License-Identifier: Apache-2.0
// Without these, a verdict could rest on noise, or never be reached.
#include "metrics/error/verdict.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbrameter {
namespace {

constexpr int kSize_px = 64;
constexpr int kTile_px = 8;

std::vector<uint8_t> everywhere() {
  return std::vector<uint8_t>(size_t{kSize_px} * kSize_px, 1);
}

Image constant(float visibility) {
  Image image(kSize_px, kSize_px);
  image.add_plane("visibility", visibility);
  return image;
}

// Truth .5; the standard error of the mean of both halves is `se`.
Image noisy_half(double se, uint64_t seed) {
  Image image = constant(0.5f);
  const std::span<float> a = image.add_plane("half_a"), b = image.add_plane("half_b");
  image.add_plane("visibility_se", static_cast<float>(se));
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, se * std::sqrt(2.0));
  for (size_t i = 0; i < a.size(); ++i) {
    a[i] = static_cast<float>(0.5 + noise(random));
    b[i] = static_cast<float>(0.5 + noise(random));
    image.plane("visibility")[i] = 0.5f * (a[i] + b[i]);
  }
  return image;
}

// Wrong by +-`error`, the sign by chance for each pixel.
Image wrong_by(float error, uint64_t seed) {
  Image image = constant(0.5f);
  std::mt19937_64 random(seed);
  for (float& v : image.plane("visibility")) v += random() % 2 == 0 ? error : -error;
  return image;
}

ComparisonVerdict compare(const Image& candidate, const Image& baseline, const Image& reference) {
  return *compare_runs(candidate, baseline, reference, everywhere(), {.tile_px = kTile_px});
}

TEST(CompareRuns, TellsBetterFromWorseAndSwapsWithTheOperands) {
  const Image reference = noisy_half(0.01, 1), good = wrong_by(0.02f, 2), bad = wrong_by(0.06f, 3);
  const ComparisonVerdict better = compare(good, bad, reference);
  EXPECT_EQ(better.outcome, Comparison::better);
  EXPECT_NEAR(better.mse_difference.value, 0.0004 - 0.0036, 2e-4);
  EXPECT_FALSE(better.sample_factor);
  const ComparisonVerdict worse = compare(bad, good, reference);
  EXPECT_EQ(worse.outcome, Comparison::worse);
  EXPECT_DOUBLE_EQ(worse.mse_difference.value, -better.mse_difference.value);
}

TEST(CompareRuns, AnImageIsTheSameAsItself) {
  const Image reference = noisy_half(0.05, 1), image = wrong_by(0.05f, 2);
  const ComparisonVerdict verdict = compare(image, image, reference);
  EXPECT_EQ(verdict.outcome, Comparison::same);
  EXPECT_EQ(verdict.mse_difference.value, 0.0);
  EXPECT_EQ(verdict.mse_difference.high, 0.0);
}

TEST(CompareRuns, ErrorsOfOneSizeAreTheSameOnceTheNoiseIsSmall) {
  EXPECT_EQ(compare(wrong_by(0.05f, 2), wrong_by(0.05f, 3), noisy_half(0.002, 1)).outcome, Comparison::same);
}

TEST(CompareRuns, NoiseOfTheReferenceDecidesNothing) {
  // Two images that are equally wrong: a claim either way is false; 5 % of trials, 200 trials, sd 1.5 %.
  const Image candidate = wrong_by(0.02f, 2), baseline = wrong_by(0.02f, 3);
  int claims = 0;
  for (uint64_t trial = 1; trial <= 200; ++trial) {
    const Comparison outcome = compare(candidate, baseline, noisy_half(0.06, trial)).outcome;
    claims += outcome == Comparison::better || outcome == Comparison::worse ? 1 : 0;
  }
  EXPECT_LT(claims / 200.0, 0.05 + 3 * 0.015);
}

TEST(CompareRuns, MoreSamplesDecideAndTheirNumberIsForetold) {
  // The difference is 1.2 standard deviations of the noise; the foretold number is as noisy, so 20 times at least.
  const Image candidate = wrong_by(0.0200f, 2), baseline = wrong_by(0.0216f, 3);
  const double se = 0.06;
  int decided_before = 0, decided_after = 0, foretold = 0;
  for (uint64_t trial = 1; trial <= 40; ++trial) {
    const ComparisonVerdict verdict = compare(candidate, baseline, noisy_half(se, trial));
    if (verdict.outcome == Comparison::better) ++decided_before;
    if (verdict.outcome != Comparison::cannot_tell || !verdict.sample_factor) continue;
    ++foretold;
    EXPECT_GT(*verdict.sample_factor, 1.0);
    const double factor = std::max(*verdict.sample_factor, 20.0);
    const Image finer = noisy_half(se / std::sqrt(factor), 1000 + trial);
    decided_after += compare(candidate, baseline, finer).outcome == Comparison::better ? 1 : 0;
  }
  EXPECT_LT(decided_before, 20);
  EXPECT_GT(foretold, 8);
  EXPECT_GE(decided_after, foretold * 9 / 10);
}

TEST(CompareRuns, WhereOnlyPlacesDifferNoSamplesHelp) {
  // Exact reference; one better in the left, the other in the right half, all but equal in sum.
  Image candidate = constant(0.5f), baseline = candidate;
  for (size_t i = 0; i < candidate.pixel_count(); ++i) {
    (i % kSize_px < kSize_px / 2 ? candidate : baseline).plane("visibility")[i] = i % 31 == 0 ? 0.7f : 0.6f;
  }
  candidate.plane("visibility")[3] = 0.9f;
  const ComparisonVerdict verdict = compare(candidate, baseline, noisy_half(0.0, 1));
  EXPECT_EQ(verdict.outcome, Comparison::cannot_tell);
  EXPECT_FALSE(verdict.sample_factor);
}

TEST(CompareRuns, AnEmptyMaskIsNotApplicable) {
  const Image image = noisy_half(0.01, 1);
  EXPECT_FALSE(compare_runs(image, image, image, std::vector<uint8_t>(image.pixel_count(), 0)));
}

TEST(CompareRuns, RejectsOtherSizesAndNamesABadPixel) {
  const Image reference = noisy_half(0.01, 1);
  Image bad = constant(0.5f);
  bad.plane("visibility")[kSize_px + 7] = std::nanf("");
  try {
    compare(constant(0.5f), bad, reference);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'visibility' is nan at pixel (7, 1)"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(compare(Image(3, 3), constant(0.5f), reference), Error);
}

TEST(JudgeLimit, PassesFailsOrAsksForSamples) {
  const Image test = wrong_by(0.05f, 2);
  const VisibilityError clear =
      measure_visibility_error(test, noisy_half(0.005, 1), everywhere(), {.tile_px = kTile_px});
  EXPECT_EQ(judge_limit(clear, 0.06)->outcome, LimitOutcome::pass);
  EXPECT_EQ(judge_limit(clear, 0.04)->outcome, LimitOutcome::fail);
  const VisibilityError noisy =
      measure_visibility_error(test, noisy_half(0.06, 1), everywhere(), {.tile_px = kTile_px});
  const auto verdict = judge_limit(noisy, std::sqrt(1.08 * noisy.mse->value));
  EXPECT_EQ(verdict->outcome, LimitOutcome::cannot_tell);
  EXPECT_GT(verdict->sample_factor.value_or(0.0), 1.0);
}

TEST(JudgeLimit, KnowsTheNoiseOfTheDebiasedError) {
  // var of a product of two halves with variance 2 se^2 each, truth .5, error e: 4 e^2 se^2 + 4 se^4.
  const double se = 0.05, e = 0.05, pixels = static_cast<double>(kSize_px) * kSize_px;
  const VisibilityError error = measure_visibility_error(wrong_by(0.05f, 2), noisy_half(se, 1), everywhere());
  const double expected = std::sqrt((4 * e * e * se * se + 4 * std::pow(se, 4)) / pixels);
  EXPECT_NEAR(*error.mse_noise_sd, expected, 0.04 * expected);
}

TEST(JudgeLimit, IsNotApplicableWithoutPixelsAndRejectsNoLimit) {
  EXPECT_FALSE(judge_limit(VisibilityError{}, 0.1));
  EXPECT_THROW(judge_limit(VisibilityError{}, 0.0), Error);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a filter of constant width could pass for contact hardening.
#include "metrics/penumbra/contact_hardening.h"

#include "tests/unit/metrics/synthetic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbrameter {
namespace {

// `count` accepted profiles, reference widths from 0.1 up by `octaves`, test widths by 2^curve(log2
// reference).
template <class Curve>
PenumbraError profiles(size_t count, double octaves, const Curve& curve) {
  PenumbraError penumbra;
  for (size_t k = 0; k < count; ++k) {
    PenumbraProfile profile;
    const double x = std::log2(0.1) + octaves * static_cast<double>(k) / static_cast<double>(count - 1);
    profile.reference_width_world = std::exp2(x);
    profile.test_width_world = std::exp2(curve(x));
    profile.x = 8 * static_cast<int>(k);
    penumbra.profiles.push_back(profile);
  }
  return penumbra;
}

TEST(ContactHardening, TheTruthHasSlopeOneAndInterceptZero) {
  const ContactHardening curve = measure_contact_hardening(profiles(100, 4.0, [](double x) { return x; }));
  EXPECT_EQ(curve.profiles, 100u);
  EXPECT_NEAR(*curve.slope, 1.0, 1e-9);
  EXPECT_NEAR(*curve.intercept_octaves, 0.0, 1e-9);
}

TEST(ContactHardening, AConstantWidthHasSlopeZero) {
  const ContactHardening curve = measure_contact_hardening(profiles(100, 4.0, [](double) { return -1.0; }));
  EXPECT_NEAR(*curve.slope, 0.0, 1e-9);
}

TEST(ContactHardening, ADiameterTakenForARadiusIsOneOctave) {
  const ContactHardening curve =
      measure_contact_hardening(profiles(700, 3.0, [](double x) { return x + 1.0; }));
  EXPECT_NEAR(*curve.slope, 1.0, 1e-9);
  EXPECT_NEAR(*curve.intercept_octaves, 1.0, 1e-9);
}

TEST(ContactHardening, SwappedReceiverAndBlockerHasANegativeSlope) {
  const ContactHardening curve = measure_contact_hardening(profiles(100, 4.0, [](double x) { return -x; }));
  EXPECT_NEAR(*curve.slope, -1.0, 1e-9);
}

TEST(ContactHardening, AFifthOfWildProfilesDoesNotMoveTheLine) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> wild(-6.0, 6.0);
  size_t k = 0;
  const ContactHardening curve = measure_contact_hardening(
      profiles(300, 4.0, [&](double x) { return ++k % 5 == 0 ? wild(random) : 0.5 * x; }));
  EXPECT_NEAR(*curve.slope, 0.5, 0.05);
}

TEST(ContactHardening, LessThanAnOctaveIsNotIdentifiable) {
  const ContactHardening curve = measure_contact_hardening(profiles(100, 1.0, [](double x) { return x; }));
  EXPECT_NEAR(curve.octaves, 0.9, 0.03);
  EXPECT_FALSE(curve.slope || curve.intercept_octaves);
}

TEST(ContactHardening, LessThanTwoOctavesNeedProfilesThatAgree) {
  std::mt19937 random(3);
  const auto curve_of = [&](size_t count, double sigma) {
    std::normal_distribution<double> noise(0.0, sigma);
    return measure_contact_hardening(profiles(count, 1.7, [&](double x) { return 0.5 * x + noise(random); }));
  };
  const ContactHardening sure = curve_of(200, 0.1);
  ASSERT_TRUE(sure.slope);
  EXPECT_NEAR(*sure.slope, 0.5, 0.05);
  EXPECT_FALSE(curve_of(20, 0.3).slope);
}

TEST(ContactHardening, FewOrNoProfilesAreNotIdentifiable) {
  EXPECT_FALSE(measure_contact_hardening(profiles(7, 5.0, [](double x) { return x; })).slope);
  EXPECT_FALSE(measure_contact_hardening({}).slope);
}

TEST(ContactHardening, HardEdgesTellNothing) {
  PenumbraError penumbra = profiles(100, 4.0, [](double) { return -7.0; });
  for (PenumbraProfile& profile : penumbra.profiles) profile.width_octaves = -3.0;
  EXPECT_FALSE(measure_contact_hardening(penumbra).slope);
}

// An edge whose penumbra grows along z from 4 to 68 px; it passes 16 squares of 64 px.
double growing_width(double z) {
  return 0.04 + 0.0625 * z;
}

Image edge_of(const std::function<double(double)>& width, uint64_t seed) {
  return testing::lit_floor(
      testing::floor_from_above(128, 1024, 0.01),
      [&](double x, double z) { return testing::box_ramp(x - 0.64, width(z)); }, 256, seed);
}

// Of 20 pictures with noise, those whose interval holds the slope.
int intervals_that_hold(double slope, const std::function<double(double)>& test_width) {
  int hold = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Image reference = edge_of(growing_width, 2 * seed), test = edge_of(test_width, 2 * seed + 1);
    const ContactHardening curve =
        measure_contact_hardening(measure_penumbra(test, reference, testing::everywhere(reference)));
    if (!curve.slope || !curve.slope_margin) continue;
    EXPECT_LT(*curve.slope_margin, 0.1);
    hold += std::abs(*curve.slope - slope) <= *curve.slope_margin ? 1 : 0;
  }
  return hold;
}

// Of intervals of 95 %, 16 or fewer of 20 hold in 2 % of the cases.
TEST(ContactHardening, TheTruthsIntervalHoldsOne) {
  EXPECT_GE(intervals_that_hold(1.0, growing_width), 17);
}

TEST(ContactHardening, AFixedFiltersIntervalHoldsZero) {
  EXPECT_GE(intervals_that_hold(0.0, [](double) { return 0.2; }), 17);
}

TEST(ContactHardening, ASquareRootsIntervalHoldsAHalf) {
  EXPECT_GE(intervals_that_hold(0.5, [](double z) { return 0.4 * std::sqrt(growing_width(z)); }), 17);
  EXPECT_LE(intervals_that_hold(1.0, [](double z) { return 0.4 * std::sqrt(growing_width(z)); }), 3);
}

// Neighbours share their edge's error, so that many of them are no surer than their places are.
TEST(ContactHardening, TheMarginCountsPlacesNotProfiles) {
  int hold = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.3);
    double shared = 0.0;
    size_t k = 0;
    const ContactHardening curve = measure_contact_hardening(profiles(240, 3.0, [&](double x) {
      if (k++ % 8 == 0) shared = noise(random);
      return 0.5 * x + shared;
    }));
    hold += std::abs(*curve.slope - 0.5) <= *curve.slope_margin ? 1 : 0;
  }
  EXPECT_GE(hold, 35);  // 38 on average; fewer in 3 % of the cases
}

TEST(ContactHardening, OnePlaceTellsNoMargin) {
  PenumbraError penumbra = profiles(100, 4.0, [](double x) { return x; });
  for (PenumbraProfile& profile : penumbra.profiles) profile.x = 0;
  EXPECT_FALSE(measure_contact_hardening(penumbra).slope_margin);
}

TEST(ContactHardening, RejectedProfilesDoNotCount) {
  PenumbraError penumbra = profiles(100, 4.0, [](double x) { return x; });
  for (PenumbraProfile& profile : penumbra.profiles) profile.outcome = ProfileOutcome::unreached;
  EXPECT_EQ(measure_contact_hardening(penumbra).profiles, 0u);
}

}  // namespace
}  // namespace umbrameter

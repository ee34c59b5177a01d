// SPDX-License-Identifier: Apache-2.0
// Without these, a filter of constant width could pass for contact hardening.
#include "metrics/contact_hardening.h"

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

TEST(ContactHardening, RejectedProfilesDoNotCount) {
  PenumbraError penumbra = profiles(100, 4.0, [](double x) { return x; });
  for (PenumbraProfile& profile : penumbra.profiles) profile.outcome = ProfileOutcome::unreached;
  EXPECT_EQ(measure_contact_hardening(penumbra).profiles, 0u);
}

}  // namespace
}  // namespace umbrameter

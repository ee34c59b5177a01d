// SPDX-License-Identifier: Apache-2.0
// Without these, every width could be off by a constant.
#include "metrics/statistics/isotonic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

TEST(FitNondecreasing, KeepsARise) {
  const std::vector<double> rise = {0.0, 0.25, 0.25, 1.0};
  EXPECT_EQ(fit_nondecreasing(rise), rise);
}

TEST(FitNondecreasing, PoolsViolatorsToTheirMean) {
  // 3,1 pool to 2,2; then 0 pulls them to 4/3.
  const std::vector<double> expected = {4.0 / 3, 4.0 / 3, 4.0 / 3, 5.0};
  const std::vector<double> fitted = fit_nondecreasing(std::vector<double>{3.0, 1.0, 0.0, 5.0});
  for (size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(fitted[i], expected[i]);
}

TEST(MeasureTransition, ABoxRampHasItsOwnWidth) {
  // Uniform density over [1, 4]: W = 3, 10-90 = .8 * 3, centre 2.5.
  const std::vector<double> position = {0.0, 1.0, 4.0, 9.0}, value = {0.0, 0.0, 1.0, 1.0};
  const auto transition = measure_transition(position, value);
  ASSERT_TRUE(transition);
  EXPECT_DOUBLE_EQ(transition->width, 3.0);
  EXPECT_DOUBLE_EQ(transition->width_10_90, 2.4);
  EXPECT_DOUBLE_EQ(transition->center, 2.5);
}

TEST(MeasureTransition, PlateausDoNotCount) {
  // The same ramp between .1 and .7, and long plateaus.
  const std::vector<double> position = {-100.0, 1.0, 4.0, 100.0}, value = {0.1, 0.1, 0.7, 0.7};
  EXPECT_NEAR(measure_transition(position, value)->width, 3.0, 1e-12);
}

TEST(MeasureTransition, AStepIsAsWideAsItsSpacingAndResolvesNothing) {
  for (const double spacing : {0.25, 1.0, 4.0}) {
    const std::vector<double> position = {0.0, spacing, 2.0 * spacing}, value = {0.0, 0.0, 1.0};
    const auto transition = measure_transition(position, value);
    EXPECT_DOUBLE_EQ(transition->width, spacing);
    EXPECT_EQ(transition->resolved_width, 0.0);
    EXPECT_EQ(transition->resolved_width_10_90, 0.0);
  }
}

TEST(MeasureTransition, TheCenterIsTheMiddleOfAPlateauAtHalfHeight) {
  // Two steps about a plateau from 2 to 6 at exactly one half: 4, where the first crossing is at 2.
  const std::vector<double> position = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0};
  const std::vector<double> value = {0.0, 0.0, 0.5, 0.5, 0.5, 0.5, 0.5, 1.0, 1.0};
  EXPECT_DOUBLE_EQ(measure_transition(position, value)->center, 4.0);
}

TEST(MeasureTransition, TheCenterOfAStairIsThatOfItsRampForAnyNumberOfLevels) {
  for (const int levels : {2, 4, 8, 16, 17}) {
    std::vector<double> position, value;
    for (int k = 0; k <= 400; ++k) {
      position.push_back(0.01 * k);
      const double ramp = std::clamp((position.back() - 1.0) / 2.0, 0.0, 1.0);
      value.push_back(std::floor(ramp * levels + 0.5) / levels);
    }
    EXPECT_NEAR(measure_transition(position, value)->center, 2.0, 0.006) << levels;
  }
}

TEST(MeasureTransition, AStretchOfARampIsThatPartOfIt) {
  // Levels cut a ramp of 4 between samples that lie 1 apart.
  const std::vector<double> position = {0.0, 1.0, 2.0, 3.0, 4.0}, value = {0.0, 0.25, 0.5, 0.75, 1.0};
  const auto stretch = measure_transition(position, value, {0.1, 0.7});
  EXPECT_NEAR(stretch->width, 0.6 * 4.0, 1e-12);
  EXPECT_NEAR(stretch->center, 1.6, 1e-12);
  EXPECT_FALSE(measure_transition(position, value, {1.2, 1.4}));
}

TEST(MeasureTransition, AFlatProfileHasNone) {
  const std::vector<double> position = {0.0, 1.0}, value = {0.5, 0.5};
  EXPECT_FALSE(measure_transition(position, value));
  EXPECT_FALSE(measure_transition(std::vector<double>{0.0}, std::vector<double>{0.5}));
}

}  // namespace
}  // namespace umbrameter

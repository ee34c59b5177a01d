// SPDX-License-Identifier: Apache-2.0
// Without these, every width could be off by a constant.
#include "metrics/isotonic.h"

#include <gtest/gtest.h>

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

TEST(MeasureTransition, AStepIsAsWideAsItsSpacing) {
  const std::vector<double> position = {0.0, 1.0, 2.0}, value = {0.0, 0.0, 1.0};
  EXPECT_DOUBLE_EQ(measure_transition(position, value)->width, 1.0);
}

TEST(MeasureTransition, AFlatProfileHasNone) {
  const std::vector<double> position = {0.0, 1.0}, value = {0.5, 0.5};
  EXPECT_FALSE(measure_transition(position, value));
  EXPECT_FALSE(measure_transition(std::vector<double>{0.0}, std::vector<double>{0.5}));
}

}  // namespace
}  // namespace umbrameter

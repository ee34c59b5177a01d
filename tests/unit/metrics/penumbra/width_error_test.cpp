// SPDX-License-Identifier: Apache-2.0
// Without these a tuner could gain by destroying penumbrae.

#include "metrics/penumbra/width_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

PenumbraProfile profile(ProfileOutcome outcome, double width_octaves = 0.0) {
  PenumbraProfile one;
  one.outcome = outcome;
  one.width_octaves = width_octaves;
  return one;
}

TEST(WidthError, IsTheRootMeanSquareOfWhatTheTruthHas) {
  using enum ProfileOutcome;
  const std::vector<PenumbraProfile> profiles = {profile(accepted, 1.0), profile(accepted, -1.0),
                                                 profile(too_narrow, 3.0)};
  EXPECT_DOUBLE_EQ(*measure_width_error(profiles), 1.0);
  EXPECT_FALSE(measure_width_error({}));
  EXPECT_FALSE(measure_width_error(std::vector{profile(too_narrow)}));
}

TEST(WidthError, ALostPenumbraIsAsWrongAsOneCanBe) {
  using enum ProfileOutcome;
  EXPECT_DOUBLE_EQ(*measure_width_error(std::vector{profile(test_unreached)}), kLostOctaves);
  EXPECT_DOUBLE_EQ(*measure_width_error(std::vector{profile(test_not_monotone)}), kLostOctaves);
  EXPECT_DOUBLE_EQ(*measure_width_error(std::vector{profile(accepted, -7.0)}), kLostOctaves);
  EXPECT_DOUBLE_EQ(*measure_width_error(std::vector{profile(accepted), profile(test_unreached)}),
                   kLostOctaves / std::sqrt(2.0));
}

TEST(WidthError, HasAnIntervalAroundItsValue) {
  using enum ProfileOutcome;
  const std::vector<PenumbraProfile> profiles = {profile(accepted, 0.5), profile(accepted, 1.0),
                                                 profile(accepted, 1.5)};
  const auto interval = width_error_interval(profiles);
  ASSERT_TRUE(interval);
  EXPECT_DOUBLE_EQ(interval->value, *measure_width_error(profiles));
  EXPECT_LT(interval->low, interval->value);
  EXPECT_GT(interval->high, interval->value);
  EXPECT_FALSE(width_error_interval({}));
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a time could be the median of other numbers, or an interval narrower than its promise.

#include "metrics/statistics/frame_times.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

namespace umbrameter {
namespace {

TEST(MedianSpread, IsRobustToOneOutlier) {
  // Sorted 1 2 3 4 100: median 3; distances from it 0 1 1 2 97: median 1.
  const std::array<double, 5> values = {100.0, 2.0, 4.0, 1.0, 3.0};
  EXPECT_EQ(median_spread(values).median, 3.0);
  EXPECT_EQ(median_spread(values).mad, 1.0);
}

TEST(MedianSpread, TakesTheMiddleOfAnEvenCountAndNothingFromNothing) {
  // Median of 1 2 4 8 is 3; distances 1 1 2 5: median 1.5.
  const std::array<double, 4> values = {8.0, 1.0, 4.0, 2.0};
  EXPECT_EQ(median_spread(values).median, 3.0);
  EXPECT_EQ(median_spread(values).mad, 1.5);
  EXPECT_EQ(median_spread({}).median, 0.0);
  EXPECT_EQ(median_spread({}).mad, 0.0);
}

TEST(MedianInterval, TakesTheRanksOfTheSignTest) {
  // Tables of the sign test at 95 %: six values give the whole range (coverage 1 - 2/64 = 0.969), ten the 2nd and 9th
  // (0.979), thirty the 10th and 21st (0.957).
  for (const auto& [count, rank] : {std::pair{6, 1}, {10, 2}, {30, 10}}) {
    std::vector<double> values(static_cast<size_t>(count));
    std::iota(values.rbegin(), values.rend(), 1.0);
    const auto interval = median_interval(values);
    ASSERT_TRUE(interval) << count;
    EXPECT_EQ(interval->low, rank);
    EXPECT_EQ(interval->high, count + 1 - rank);
    EXPECT_EQ(interval->value, 0.5 * (count + 1));
  }
}

TEST(MedianInterval, IsAbsentWhereEvenTheWholeRangeSaysTooLittle) {
  // Five values: coverage 1 - 2/32 = 0.9375.
  EXPECT_FALSE(median_interval(std::array{1.0, 2.0, 3.0, 4.0, 5.0}));
  EXPECT_FALSE(median_interval({}));
}

TEST(FrameTimesTest, TheTotalIsSummedFrameByFrame) {
  // Totals 11, 12, 4: median 11, although the passes' medians are 2 and 9.
  const FrameTimes times{{"map", "filter"}, {{1, 10}, {3, 9}, {2, 2}}};
  const std::vector<PassTime> summary = summarise(times);
  ASSERT_EQ(summary.size(), 3u);
  EXPECT_EQ(summary[0].pass, "map");
  EXPECT_EQ(summary[0].median_ms, 2.0);
  EXPECT_EQ(summary[1].median_ms, 9.0);
  EXPECT_EQ(summary[2].pass, "total");
  EXPECT_EQ(summary[2].median_ms, 11.0);
  EXPECT_EQ(summary[2].mad_ms, 1.0);
  EXPECT_EQ(summary[2].frames, 3);
  const std::vector<std::string> without{"map"};
  EXPECT_EQ(frame_totals(times, without), (std::vector<double>{10, 9, 2}));
  EXPECT_TRUE(times_of_pass(times, "blur").empty());
  EXPECT_TRUE(summarise({{"map"}, {}}).empty());
}

}  // namespace
}  // namespace umbrameter

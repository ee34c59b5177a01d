// SPDX-License-Identifier: Apache-2.0
// Without these a recommendation could rest on a run that was never timed, or on one lucky scene.

#include "results/bench/recommend.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

BenchEntry entry(const std::string& label, double time_ms, double rmse) {
  BenchEntry result;
  result.label = label;
  result.time_ms = Interval{time_ms, time_ms, time_ms};
  result.error.emplace().rmse = Interval{rmse, rmse, rmse};
  result.has_place = true;
  return result;
}

TEST(Recommend, TakesTheLeastProductOfTimeAndError) {
  // Products 0.4, 0.2 and 0.3.
  std::vector<BenchEntry> entries{entry("fast", 1, 0.4), entry("knee", 2, 0.1), entry("good", 10, 0.03)};
  EXPECT_EQ(recommended(entries), 1u);
  entries[1].error->rmse->high = 0.2;  // 0.4: its error may be that large
  EXPECT_EQ(recommended(entries), 2u);
  entries[2].has_place = false;
  EXPECT_EQ(recommended(entries), 0u);
  EXPECT_FALSE(recommended(std::vector<BenchEntry>{}));
}

TEST(Recommend, TheOverallRunIsSeldomFarFromTheBest) {
  BenchScene first, second;
  first.entries = {entry("a", 1, 0.1), entry("b", 1, 0.2), entry("everywhere", 1, 0.11)};
  second.entries = {entry("a", 1, 0.9), entry("b", 1, 0.1), entry("everywhere", 1, 0.12)};
  const std::vector<BenchScene> scenes{first, second};
  const auto overall = recommended_overall(scenes);
  ASSERT_TRUE(overall);
  EXPECT_EQ(overall->label, "everywhere");
  EXPECT_NEAR(overall->cost, std::sqrt(1.1 * 1.2), 1e-12);
  EXPECT_EQ(overall->scenes, 2u);
}

TEST(Recommend, ARunThatMissesAScenesIsNotTheBestOverall) {
  BenchScene first, second;
  first.entries = {entry("a", 1, 0.1), entry("b", 1, 0.2)};
  second.entries = {entry("b", 1, 0.1)};
  const std::vector<BenchScene> scenes{first, second};
  EXPECT_EQ(recommended_overall(scenes)->label, "b");
  EXPECT_FALSE(recommended_overall(std::vector<BenchScene>{}));
}

}  // namespace
}  // namespace umbrameter

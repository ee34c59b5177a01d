// SPDX-License-Identifier: Apache-2.0
// Without these a sample could leave out a part of a parameter's range, or differ from one machine to the next.

#include "study/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace umbrameter {
namespace {

using testing::HasSubstr;

std::vector<StudyRun> runs_of(const std::string& sample, const std::string& values = "") {
  return parse_study(
             "schema = 1\ntitle = \"t\"\nscenes = [\"plate\"]\n[[run]]\nlabel = \"x\"\ntechnique = "
             "\"pcf\"\n" +
                 values + "[run.sample]\n" + sample,
             "study.toml")
      .runs;
}

TEST(RunSampleTest, EveryPieceOfEveryRangeIsMetOnce) {
  const auto runs = runs_of("count = 40\na = [0.0, 1.0]\nb = { log = [0.01, 100.0] }\nc = [0, 39]\n");
  ASSERT_EQ(runs.size(), 40u);
  std::set<int> linear, logarithmic, whole;
  for (const StudyRun& run : runs) {
    linear.insert(static_cast<int>(run.values[0].second.real * 40.0));
    logarithmic.insert(static_cast<int>((std::log10(run.values[1].second.real) + 2.0) * 10.0));
    EXPECT_EQ(run.values[2].second.type, TomlNode::Type::integer);
    whole.insert(static_cast<int>(run.values[2].second.integer));
  }
  EXPECT_EQ(linear.size(), 40u);
  EXPECT_EQ(logarithmic.size(), 40u);
  EXPECT_EQ(whole.size(), 40u);
  EXPECT_EQ(*whole.begin(), 0);
  EXPECT_EQ(*whole.rbegin(), 39);
}

TEST(RunSampleTest, ASeedPairsThePiecesAndTheSameSeedAlike) {
  const std::string axes = "a = [0.0, 1.0]\nb = [0.0, 1.0]\n";
  const auto labels = [&](const std::string& seed) {
    std::vector<std::string> texts;
    for (const StudyRun& run : runs_of("count = 8\n" + seed + axes)) texts.push_back(run.label);
    return texts;
  };
  EXPECT_EQ(labels(""), labels("seed = 1\n"));
  EXPECT_NE(labels("seed = 1\n"), labels("seed = 2\n"));
}

TEST(RunSampleTest, ListsAreMetEquallyOftenAndEqualPointsComeOnce) {
  const auto runs = runs_of("count = 8\nsize = { list = [256, 512] }\nspread = [0.0, 1.0]\n");
  ASSERT_EQ(runs.size(), 8u);
  EXPECT_EQ(
      std::ranges::count_if(runs, [](const StudyRun& run) { return run.values[0].second.integer == 256; }),
      4);
  EXPECT_EQ(runs_of("count = 8\nsize = { list = [256, 512] }\n").size(), 2u);
}

TEST(RunSampleTest, SamplesMultiplyTheGridAndFillLabels) {
  const auto runs = runs_of("count = 3\na = [0, 2]\n", "[run.values]\nfit = [\"light\", \"visible\"]\n");
  ASSERT_EQ(runs.size(), 6u);
  EXPECT_THAT(runs[0].label, testing::MatchesRegex("x fit=light a=[0-2]"));
  EXPECT_THAT(runs[5].label, testing::MatchesRegex("x fit=visible a=[0-2]"));
}

TEST(RunSampleTest, SlipsAreErrors) {
  const auto problem = [](const std::string& sample, const std::string& values = "") {
    try {
      runs_of(sample, values);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(problem("a = [0, 1]\n"), HasSubstr("count"));
  EXPECT_THAT(problem("count = 0\na = [0, 1]\n"), HasSubstr("not in 1 to"));
  EXPECT_THAT(problem("count = 2\n"), HasSubstr("no parameters"));
  EXPECT_THAT(problem("count = 2\na = [1, 1]\n"), HasSubstr("is empty"));
  EXPECT_THAT(problem("count = 2\na = { log = [0, 1] }\n"), HasSubstr("0 < low < high"));
  EXPECT_THAT(problem("count = 2\na = { list = [] }\n"), HasSubstr("no list of values"));
  EXPECT_THAT(problem("count = 2\na = { range = [0, 1] }\n"), HasSubstr("is a table"));
  EXPECT_THAT(problem("count = 2\na = 3\n"), HasSubstr("not two numbers"));
  EXPECT_THAT(problem("count = 2\na = [0, 1]\n", "[run.values]\na = 3\n"), HasSubstr("among the samples"));
}

}  // namespace
}  // namespace umbrameter

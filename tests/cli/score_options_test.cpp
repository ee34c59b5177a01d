// SPDX-License-Identifier: Apache-2.0
// Without these, --metrics, --baseline and --limit could be read and ignored.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class ScoreOptions : public CliTest {
 protected:
  // One scene's truth with two seeds: 1 is the reference, 2 as good as the truth.
  void SetUp() override {
    for (const std::string seed : {"1", "2"}) {
      const ProcessResult result = umbrameter({"reference", "plate", "--width", "96", "--height", "64",
                                               "--spp", "64", "--seed", seed, "-o", seed + ".exr"});
      ASSERT_EQ(result.exit_code, 0) << result.err;
    }
  }
  ProcessResult score(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"score", "2.exr", "--reference", "1.exr"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return umbrameter(arguments);
  }
};

TEST_F(ScoreOptions, ComputeOnlyWhatWasAskedFor) {
  const Json json = Json::parse(score({"--metrics", "error", "--json"}).out);
  EXPECT_FALSE(json["error"].is_null());
  for (const char* key : {"significance", "verdict", "limit", "penumbra", "faults"}) {
    EXPECT_TRUE(json.at(key).is_null()) << key;
  }
  expect_bad_input(score({"--metrics", "error,speed"}), "unknown metric 'speed'");
}

TEST_F(ScoreOptions, ATruthOfAnotherSeedIsNotWrongBeyondTheNoise) {
  const Json significance = Json::parse(score({"--json"}).out)["significance"];
  // 5 % of discoveries may be false, so a few pixels of 6144 are no surprise.
  EXPECT_LE(significance["too_dark"].get<int>() + significance["too_bright"].get<int>(), 10);
  EXPECT_GT(significance["tested"].get<int>(), 1000);
}

TEST_F(ScoreOptions, AnImageIsTheSameAsItself) {
  const Json verdict = Json::parse(score({"--baseline", "2.exr", "--json"}).out)["verdict"];
  EXPECT_EQ(verdict["outcome"], "same");
  EXPECT_EQ(verdict["baseline"], "2.exr");
}

TEST_F(ScoreOptions, ALimitDecidesTheExitCode) {
  const ProcessResult kept = score({"--limit", "0.5"});
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_THAT(kept.out, HasSubstr("RMSE 0.5: pass"));
  for (const std::string limit : {"-1", "0", "inf"}) {
    const ProcessResult refused = score({"--limit", limit});
    EXPECT_EQ(refused.exit_code, 2) << limit;
    EXPECT_THAT(refused.err, HasSubstr("--limit: '" + limit + "' is not a number above 0")) << limit;
  }
}

}  // namespace
}  // namespace umbrameter

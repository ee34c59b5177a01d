// SPDX-License-Identifier: Apache-2.0
// Without these the exact check could stop working end to end, or choose its points by their errors.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class ExactCheckCommand : public CliTest {};

const std::vector<std::string> kSmall{"reference", "plate", "--width", "96",
                                      "--height",  "54",    "--spp",   "256"};

std::vector<std::string> with(std::vector<std::string> more) {
  more.insert(more.begin(), kSmall.begin(), kSmall.end());
  return more;
}

TEST_F(ExactCheckCommand, ReportsCoverageMeanErrorAndTheWorstPoint) {
  const ProcessResult result = umbrameter(with({"--exact-check", "80", "--json"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json check = Json::parse(result.out)["exact_check"];
  EXPECT_EQ(check["points"], 80);
  EXPECT_EQ(check["others_wrong"], 0);
  EXPECT_GE(check["penumbra"]["points"], 50);
  EXPECT_GT(check["penumbra"]["coverage"], 0.8);
  EXPECT_LT(std::abs(check["penumbra"]["mean_error"].get<double>()),
            5.0 * check["penumbra"]["mean_error_noise"].get<double>());
  EXPECT_GE(check["worst"]["x_px"], 0);
  EXPECT_LT(check["irradiance_rms_error"], 0.02);
}

TEST_F(ExactCheckCommand, SaysTheSameInWordsAndRefusesNothingToCheck) {
  EXPECT_THAT(
      umbrameter(with({"--exact-check", "20"})).out,
      testing::AllOf(testing::HasSubstr("exact check: 20 points"),
                     testing::HasSubstr("inside their 95 % interval"), testing::HasSubstr("worst, pixel (")));
  EXPECT_EQ(umbrameter(with({"--exact-check", "0"})).exit_code, 2);
}

TEST_F(ExactCheckCommand, WithoutTheOraclesProgramItSaysSoBeforeAnyWork) {
  namespace fs = std::filesystem;
  fs::create_directories(folder() / "bin");
  fs::copy(program_path(), folder() / "bin/umbrameter");
  const fs::path home = fs::canonical(fs::path(program_path()).parent_path() / "../share/umbrameter");
  std::vector<std::string> command = with({"--exact-check", "20", "-o", (folder() / "truth.exr").string()});
  command.insert(command.begin(), (folder() / "bin/umbrameter").string());
  const ProcessResult result = run_process(command, {.environment = {{"UMBRAMETER_HOME", home.string()}}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err,
              testing::HasSubstr("bin/umbrameter-exact' is not there (the package umbrameter-exact"));
  EXPECT_FALSE(fs::exists(folder() / "truth.exr"));
}

TEST_F(ExactCheckCommand, AProgramThatFailsIsNamedWithItsOwnWords) {
  namespace fs = std::filesystem;
  fs::create_directories(folder() / "bin");
  fs::copy(program_path(), folder() / "bin/umbrameter");
  write("bin/umbrameter-exact", "#!/bin/sh\necho 'out of everything' >&2\nexit 9\n");
  fs::permissions(folder() / "bin/umbrameter-exact", fs::perms::owner_all);
  const fs::path home = fs::canonical(fs::path(program_path()).parent_path() / "../share/umbrameter");
  std::vector<std::string> command = with({"--exact-check", "20", "-o", (folder() / "truth.exr").string()});
  command.insert(command.begin(), (folder() / "bin/umbrameter").string());
  const ProcessResult result = run_process(command, {.environment = {{"UMBRAMETER_HOME", home.string()}}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, testing::HasSubstr("ended with 9 after 0 of 20 points: out of everything"));
}

TEST_F(ExactCheckCommand, DrawsTheSamePointsAgain) {
  const auto worst = [&] {
    return Json::parse(umbrameter(with({"--exact-check", "40", "--json"})).out)["exact_check"]["worst"];
  };
  EXPECT_EQ(worst(), worst());
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Foreign renderers as runs. Engines that are not installed are skipped, by name.
#include "core/files.h"
#include "tests/cli/cli_fixture.h"
#include "tests/support/engine_folder.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

const std::vector<std::string> kSmall = {"--width", "96", "--height", "54", "--spp", "64", "--frames", "0"};

class EnginesTest : public CliTest {
 protected:
  ProcessResult validate(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "validate");
    arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
    arguments.insert(arguments.end(), {"--json", "--out", (folder() / "out").string()});
    return umbrameter(arguments);
  }
};

const Json& run_of(const Json& results, const std::string& label) {
  for (const Json& run : results["scenes"][0]["techniques"]) {
    if (run["label"] == label) return run;
  }
  throw std::runtime_error("no run " + label);
}

TEST_F(EnginesTest, ListsWhatShipsAndWhetherItIsThere) {
  const ProcessResult result = umbrameter({"engines", "list", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json engines = Json::parse(result.out)["engines"];
  std::vector<std::string> ids;
  for (const Json& engine : engines) ids.push_back(engine["id"]);
  EXPECT_THAT(ids, testing::IsSupersetOf({"babylon", "playcanvas", "three"}));
}

TEST_F(EnginesTest, UnknownEnginesAreNamed) {
  expect_bad_input(umbrameter({"engines", "check", "no-such"}), "there is no engine 'no-such'");
}

TEST_F(EnginesTest, AFailedEngineIsOneFailedRunAndTheRestGoesOn) {
  require_gl();
  const EngineFolder engine;
  const std::string path = engine.path().string();
  const ProcessResult result =
      validate({"plate", "--technique", "pcf", "--technique", path + ":misbehave=crash", "--technique",
                path + ":shadow.grey=0.25"});
  const Json results = Json::parse(result.out);
  EXPECT_TRUE(run_of(results, "pcf").contains("error")) << result.err;
  EXPECT_THAT(run_of(results, "tried:misbehave=crash").dump(), HasSubstr("the driver is gone"));
  // Grey everywhere, compared on the surfaces of our own rasteriser: the engine has none, and that is said.
  const Json& grey = run_of(results, "tried:shadow.grey=0.25");
  EXPECT_GT(grey["error"]["rmse"]["value"].get<double>(), 0.3);
  EXPECT_THAT(grey["warnings"].dump(), HasSubstr("the engine gave no position"));
}

/// Runs in the engine's own words, against our techniques, in one table.
void expect_engine(const ProcessResult& result, const std::string& label) {
  const Json results = Json::parse(result.out);
  const Json& run = run_of(results, label);
  ASSERT_TRUE(run.contains("error")) << run.dump() << result.err;
  // Shadows are where they belong: far better than a light scene without any, or a picture upside down.
  EXPECT_LT(run["error"]["rmse"]["value"].get<double>(), 0.12);
}

bool is_installed(const std::string& package) {
  return std::filesystem::exists(source_dir() / "engines" / "installed" / "node_modules" / package /
                                 "package.json");
}

TEST_F(EnginesTest, TheTableSaysWhatFailed) {
  require_gl();
  const EngineFolder engine;
  std::vector<std::string> arguments = {"validate", "plate", "--technique",
                                        engine.path().string() + ":misbehave=crash"};
  arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
  const ProcessResult result = umbrameter(arguments);
  EXPECT_THAT(result.err, HasSubstr("the driver is gone"));
  EXPECT_THAT(result.err, testing::Not(HasSubstr("internal")));
}

TEST_F(EnginesTest, ThreeDrawsWhatWeDraw) {
  if (!is_installed("three")) GTEST_SKIP() << "three.js is not installed: scripts/install_engines.sh";
  require_gl();
  const std::string label = "three:type=pcf,shadow.mapSize=1024,shadow.bias=-0.002,shadow.radius=4";
  expect_engine(validate({"plate", "--technique", label, "--technique", "pcf"}), label);
}

TEST_F(EnginesTest, BabylonDrawsWhatWeDraw) {
  if (!is_installed("babylonjs")) GTEST_SKIP() << "Babylon.js is not installed: scripts/install_engines.sh";
  require_gl();
  const std::string label = "babylon:type=pcss,bias=0.004,normalBias=0.01";
  expect_engine(validate({"plate", "--technique", label, "--technique", "pcf"}), label);
}

TEST_F(EnginesTest, PlayCanvasDrawsWhatWeDraw) {
  if (!is_installed("playcanvas")) GTEST_SKIP() << "PlayCanvas is not installed: scripts/install_engines.sh";
  require_gl();
  const std::string label = "playcanvas:type=pcf3,shadowBias=0.2,normalOffsetBias=0.05";
  expect_engine(validate({"plate", "--technique", label, "--technique", "pcf"}), label);
}

}  // namespace
}  // namespace umbrameter

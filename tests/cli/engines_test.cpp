// SPDX-License-Identifier: Apache-2.0
// Foreign renderers as runs. Engines that are not installed are skipped, by name.
#include "core/files.h"
#include "tests/cli/cli_fixture.h"
#include "tests/support/engine_folder.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
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
  EXPECT_THAT(ids, testing::IsSupersetOf({"babylon", "cycles", "eevee", "filament", "playcanvas", "three"}));
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
  // Shadows are where they belong: our hard map has 0.127 here, a plate whose shadow is lost 0.3.
  EXPECT_LT(run["error"]["rmse"]["value"].get<double>(), 0.15);
}

/// An npm package where scripts/install_engines.sh puts it.
std::string package(const std::string& name) {
  return (source_dir() / "engines" / "installed" / "node_modules" / name / "package.json").string();
}

#define REQUIRE_ENGINE(title, file)            \
  if (!std::filesystem::exists(file))          \
  GTEST_SKIP() << "NOT CHECKED against " title \
                  ": it is not installed, and scripts/install_engines.sh installs it"

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
  REQUIRE_ENGINE("three.js", package("three"));
  require_gl();
  const std::string label =
      "three:type=pcf,shadowSide=double,shadow.mapSize=1024,shadow.bias=-0.002,shadow.radius=4";
  expect_engine(validate({"plate", "--technique", label, "--technique", "pcf"}), label);
}

TEST_F(EnginesTest, BabylonDrawsWhatWeDraw) {
  REQUIRE_ENGINE("Babylon.js", package("babylonjs"));
  require_gl();
  const std::string label = "babylon:type=pcss";
  expect_engine(validate({"plate", "--technique", label, "--technique", "pcf"}), label);
}

TEST_F(EnginesTest, PlayCanvasDrawsWhatWeDraw) {
  REQUIRE_ENGINE("PlayCanvas", package("playcanvas"));
  require_gl();
  const std::string label = "playcanvas:type=pcf3,shadowBias=0.2,normalOffsetBias=0.05";
  expect_engine(validate({"plate", "--technique", label, "--technique", "pcf"}), label);
}

TEST_F(EnginesTest, FilamentDrawsWhatWeDraw) {
  REQUIRE_ENGINE("Filament", package("filament"));
  require_gl();
  const std::string pcf = "filament:type=pcf";
  const std::string pcss = "filament:type=pcss,shadowOptions.shadowBulbRadius=0.3";
  const ProcessResult result = validate({"plate", "--technique", pcf, "--technique", pcss});
  expect_engine(result, pcf);
  expect_engine(result, pcss);
  // Its settings arrive: these two cannot be the same picture.
  const Json results = Json::parse(result.out);
  EXPECT_NE(run_of(results, pcf)["error"]["rmse"]["value"], run_of(results, pcss)["error"]["rmse"]["value"]);
}

TEST_F(EnginesTest, FilamentsLampsCastShadowsAllAround) {
  REQUIRE_ENGINE("Filament", package("filament"));
  require_gl();
  const std::string label = "filament:type=pcf,shadowOptions.mapSize=512";
  expect_engine(validate({"under_a_bulb", "--technique", label}), label);
}

/// three.js with a page of our own, whose code sets the bias, beside it the code that all web engines share.
void copy_three_page(const std::filesystem::path& folder, const std::string& bias) {
  const auto overwrite =
      std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing;
  std::filesystem::copy(source_dir() / "engines" / "web", folder / "web", overwrite);
  std::filesystem::copy(source_dir() / "engines" / "three", folder / "page", overwrite);
  const auto replace = [&](const char* file, const std::string& from, const std::string& to) {
    std::string text = read_file(folder / "page" / file);
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_file_atomically(folder / "page" / file, text.replace(at, from.size(), to));
  };
  replace("engine.toml", "id = \"three\"", "id = \"page\"");
  replace("page.mjs", "  return light;\n", "  shadow.bias = " + bias + ";\n  return light;\n");
}

TEST_F(EnginesTest, ABrokenBiasOfAThreePageFailsTheGateAsPeterPanning) {
  REQUIRE_ENGINE("three.js", package("three"));
  require_gl();
  copy_three_page(folder(), "-0.015");
  write("suite.toml", R"(schema = 1
title = "A page"
scenes = ["box_contact"]
width_px = 192
height_px = 108
samples_per_pixel = 64
[[run]]
technique = "page"
values = { type = "pcf", shadowSide = "double", "shadow.mapSize" = 1024 }
)");
  const ProcessResult recorded = umbrameter({"regress", "record", "suite.toml", "--baseline", "base"});
  ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
  EXPECT_EQ(umbrameter({"regress", "check", "suite.toml", "--baseline", "base", "--seed", "7"}).exit_code, 0);
  copy_three_page(folder(), "-0.04");
  const ProcessResult broken = umbrameter({"regress", "check", "suite.toml", "--baseline", "base", "--json"});
  EXPECT_EQ(broken.exit_code, 1) << broken.err;
  EXPECT_EQ(Json::parse(broken.out)["cases"][0]["kind"], "peter_panning") << broken.out;
}

TEST_F(EnginesTest, EeveeDrawsWhatWeDraw) {
  REQUIRE_ENGINE("Blender EEVEE", "/usr/bin/blender");
  REQUIRE_ENGINE("Blender EEVEE", "/usr/bin/Xvfb");
  require_gl();
  const ProcessResult result = validate({"plate", "--technique", "eevee", "--technique", "pcf"});
  expect_engine(result, "eevee");
  // Soft shadows from points all over the light: far nearer to the truth than one map can be.
  EXPECT_LT(run_of(Json::parse(result.out), "eevee")["error"]["rmse"]["value"].get<double>(), 0.05);
}

TEST_F(EnginesTest, CyclesIsAtItsOwnNoise) {
  REQUIRE_ENGINE("Blender Cycles", "/usr/bin/blender");
  require_gl();
  const ProcessResult result = validate({"contact_hardening", "--technique", "cycles"});
  const Json results = Json::parse(result.out);
  const Json& run = run_of(results, "cycles");
  ASSERT_TRUE(run.contains("error")) << run.dump() << result.err;
  // As visibility it would be off by the model gap, 0.016 here.
  EXPECT_LT(std::abs(run["error"]["rmse"]["value"].get<double>()), 0.004);
  EXPECT_THAT(run["warnings"].dump(), HasSubstr("compared as irradiance ratio"));
}

TEST_F(EnginesTest, AFinishedPictureIsARun) {
  require_gl();
  const std::string picture = (folder() / "plate.exr").string();
  ASSERT_EQ(
      umbrameter({"render", "plate", "--technique", "pcf", "--width", "96", "--height", "54", "-o", picture})
          .exit_code,
      0);
  const ProcessResult result = validate({"plate", "--technique", picture, "--technique", "pcf"});
  const Json results = Json::parse(result.out);
  EXPECT_EQ(run_of(results, "plate")["error"]["rmse"], run_of(results, "pcf")["error"]["rmse"]) << result.err;
}

TEST_F(EnginesTest, StudiesTakeFinishedPictures) {
  require_gl();
  for (const char* scene : {"plate", "half_plane"}) {
    const std::string picture = (folder() / (std::string("shot-") + scene + ".exr")).string();
    ASSERT_EQ(
        umbrameter({"render", scene, "--technique", "hard", "--width", "96", "--height", "54", "-o", picture})
            .exit_code,
        0);
  }
  write_file_atomically(folder() / "study.toml", R"(
schema = 1
title = "Pictures"
scenes = ["plate", "half_plane"]
width_px = 96
height_px = 54
samples_per_pixel = 64
[[run]]
label = "ours"
technique = "hard"
[[run]]
label = "theirs"
picture = "shot-{name}.exr"
)");
  const ProcessResult swept =
      umbrameter({"sweep", (folder() / "study.toml").string(), "--json", "--out", (folder() / "s").string()});
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  // The same pictures: neither is better.
  const Json verdicts = Json::parse(swept.out)["verdicts"];
  EXPECT_EQ(verdicts["better"], 0);
  EXPECT_EQ(verdicts["worse"], 0);
}

}  // namespace
}  // namespace umbrameter

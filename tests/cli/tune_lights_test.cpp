// SPDX-License-Identifier: Apache-2.0
// Without these, two lights of a scene would have to share one bias, or one light's values could be taken for the other's.

#include "core/files.h"
#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const std::string kSun =
    "[[light]]\nname = \"sky\"\ntype = \"sun\"\ndirection = [0.3, -1, 0]\nangular_diameter_deg = 5\n";
const std::string kByLight =
    "technique = \"hard\"\n[[preset]]\nname = \"a\"\nlight = \"rect\"\n[preset.values]\nbias_texels = 0.5\n"
    "[[preset]]\nname = \"b\"\nlight = \"sky\"\n[preset.values]\nbias_texels = 3\n";

class LightPresets : public CliTest {
 protected:
  void SetUp() override {
    write_scene("two.toml", kSun);
    write("by_light.toml", kByLight);
  }
  ProcessResult tiny(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--width", "64", "--height", "36", "--spp", "64", "--json"});
    return umbrameter(arguments);
  }
};

class GlLightTuning : public LightPresets {
 protected:
  void SetUp() override {
    require_gl();
    LightPresets::SetUp();
  }
};

TEST_F(GlLightTuning, EachLightHasItsOwnValuesWindowsAndPage) {
  const std::vector<std::string> tune{
      "tune",        "two.toml",      "--technique", "hard:map_size=64", "--parameters",
      "bias_texels", "--evaluations", "6",           "--cameras",        "1"};
  const ProcessResult tuned = tiny(tune);
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
  const Json json = Json::parse(tuned.out);
  ASSERT_EQ(json["lights"].size(), 2u);
  ASSERT_EQ(json["lit_sums"].size(), 1u);
  EXPECT_EQ(json["lit_sums"][0]["scene"], "two.toml");
  EXPECT_GT(json["lit_sums"][0]["pixels"], 100);
  EXPECT_GT(json["lit_sums"][0]["lit_rmse_tuned"]["value"], 0.0);
  EXPECT_EQ(read_file(folder() / "tuned/lights.json"), tuned.out);
  const ProcessResult validated =
      tiny({"validate", "two.toml", "--preset", "tuned/hard.toml", "--frames", "0"});
  ASSERT_EQ(validated.exit_code, 0) << validated.err;
  const Json scenes = Json::parse(validated.out)["scenes"];
  for (size_t i = 0; i < 2; ++i) {
    const std::string light = i == 0 ? "rect" : "sky";
    const Json& tuning = json["lights"][i]["tuning"];
    EXPECT_EQ(json["lights"][i]["light"], light);
    EXPECT_EQ(tuning["scenes"], Json::array({"two/" + light}));
    EXPECT_LE(tuning["best"]["ratio"], 1.0);
    EXPECT_FALSE(tuning["bias_sweep"].empty());
    EXPECT_EQ(Json::parse(read_file(folder() / ("tuned/tune-" + light + ".json"))), tuning);
    EXPECT_THAT(read_file(folder() / ("tuned/hard-" + light + "-engine.txt")), HasSubstr("bias_texels = "));
    EXPECT_EQ(scenes[i]["name"], "two/" + light);
    ASSERT_EQ(scenes[i]["techniques"].size(), 1u);
    EXPECT_EQ(scenes[i]["techniques"][0]["parameters"], tuning["best"]["parameters"]) << light;
  }
  EXPECT_THAT(read_file(folder() / "tuned/report.html"), HasSubstr("two/sky"));
}

TEST_F(GlLightTuning, OneLightOrOneSettingIsTunedAsBefore) {
  const std::vector<std::string> tune{
      "tune",        "two.toml",      "--technique", "hard:map_size=64", "--parameters",
      "bias_texels", "--evaluations", "4",           "--cameras",        "1"};
  std::vector<std::string> one = tune, together = tune;
  one.insert(one.end(), {"--light", "sky"});
  together.push_back("--together");
  EXPECT_EQ(Json::parse(tiny(one).out)["scenes"], Json::array({"two/sky"}));
  EXPECT_EQ(Json::parse(tiny(together).out)["scenes"], Json::array({"two/rect", "two/sky"}));
  EXPECT_THAT(read_file(folder() / "tuned/hard.toml"), testing::Not(HasSubstr("light = ")));
}

TEST_F(GlLightTuning, VerbsTakeTheValuesOfTheLightTheyLookAt) {
  const auto bias_of = [&](const std::string& light) -> std::string {
    const ProcessResult result =
        tiny({"render", "two.toml", "--technique", "hard", "--preset", "by_light.toml", "--light", light});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out)["parameters"] : "";
  };
  EXPECT_THAT(bias_of("rect"), HasSubstr("bias_texels=0.5"));
  EXPECT_THAT(bias_of("sky"), HasSubstr("bias_texels=3"));
  write("suite.toml",
        "schema = 1\ntitle = \"t\"\nscenes = [\"two.toml\"]\nwidth_px = 64\nheight_px = 36\n"
        "samples_per_pixel = 64\nmost_samples_per_pixel = 64\n"
        "[[run]]\nlabel = \"soft\"\ntechnique = \"hard\"\npreset = \"by_light.toml\"\n");
  const ProcessResult recorded = umbrameter({"regress", "record", "suite.toml", "--baseline", "base"});
  ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
  const std::string baseline = read_file(folder() / "base/suite.toml");
  EXPECT_THAT(baseline, HasSubstr("bias_texels=0.5"));
  EXPECT_THAT(baseline, HasSubstr("bias_texels=3"));
  const ProcessResult checked =
      umbrameter({"regress", "check", "suite.toml", "--baseline", "base", "--json"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_EQ(Json::parse(checked.out)["fail"], 0);
}

TEST_F(LightPresets, FilesAreChecked) {
  const auto render = [&](const std::string& text) {
    write("preset.toml", text);
    return umbrameter(
        {"render", "two.toml", "--technique", "hard", "--light", "sky", "--preset", "preset.toml"});
  };
  const std::string head = "technique = \"hard\"\n[[preset]]\nname = \"a\"\n",
                    values = "[preset.values]\nbias_texels = 1\n";
  expect_bad_input(render(head + values + "[[preset]]\nname = \"b\"\n" + values),
                   "a preset file with several [[preset]] has one a light");
  expect_bad_input(
      render(head + "light = \"rect\"\n" + values + "[[preset]]\nname = \"b\"\nlight = \"rect\"\n" + values),
      "two presets are for light 'rect'");
  expect_bad_input(render(head + "light = \"rect\"\n" + values),
                   "has no values for light 'sky' (it has them for: rect)");
  expect_bad_input(umbrameter({"tune", "two.toml", "--technique", "hard:preset=by_light.toml"}),
                   "has values for single lights, which this command does not take");
}

}  // namespace
}  // namespace umbrameter

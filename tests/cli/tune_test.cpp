// SPDX-License-Identifier: Apache-2.0
// Without these, tuned values could be written that no other command takes.

#include "core/files.h"
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class TuneCommand : public CliTest {};
class GlTuneCommand : public CliTest {
 protected:
  void SetUp() override { require_gl(); }
};

TEST_F(GlTuneCommand, WritesAPresetThatOtherCommandsTake) {
  write_scene("scene.toml");
  const ProcessResult tuned =
      umbrameter({"tune", "scene.toml", "--technique", "pcf:map_size=64", "--parameters",
                  "filter_width_texels,bias_texels", "--evaluations", "12", "--cameras", "1", "--width", "64",
                  "--height", "36", "--spp", "64", "--out", "best", "--json"});
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
  const Json json = Json::parse(tuned.out);
  EXPECT_LE(json["evaluations"], 12);
  EXPECT_LE(json["best"]["ratio"], 1.0);
  EXPECT_EQ(json["others"][0]["name"], "default, medium");
  EXPECT_EQ(read_file(folder() / "best/tune.json"), tuned.out);
  EXPECT_THAT(read_file(folder() / "best/pcf-engine.txt"), HasSubstr("filter_width_texels = "));

  const std::vector<std::string> size = {"--width", "64", "--height", "36", "--json"};
  std::vector<std::string> by_option = {"render", "scene.toml", "--technique",
                                        "pcf",    "--preset",   "best/pcf.toml"};
  by_option.insert(by_option.end(), size.begin(), size.end());
  const ProcessResult rendered = umbrameter(by_option);
  ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
  const std::string used = Json::parse(rendered.out)["parameters"];
  EXPECT_THAT(used, HasSubstr("map_size=64"));
  const double width = json["best"]["parameters"]["filter_width_texels"];
  EXPECT_THAT(used, HasSubstr(fmt::format("filter_width_texels={}", width)));

  const ProcessResult validated =
      umbrameter({"validate", "scene.toml", "--preset", "best/pcf.toml", "--width", "64", "--height", "36",
                  "--spp", "64", "--frames", "0", "--json"});
  ASSERT_EQ(validated.exit_code, 0) << validated.err;
  const Json run = Json::parse(validated.out)["scenes"][0]["techniques"][0];
  EXPECT_EQ(run["technique"], "pcf");
  EXPECT_EQ(run["parameters"]["filter_width_texels"], width);
}

TEST_F(GlTuneCommand, TruthsAreRenderedOnce) {
  write_scene("scene.toml");
  const auto tune = [&](const std::vector<std::string>& more, bool reuses) {
    std::vector<std::string> arguments = {"tune",         "scene.toml",  "--technique",   "pcf:map_size=64",
                                          "--parameters", "bias_texels", "--evaluations", "6",
                                          "--cameras",    "1",           "--width",       "64",
                                          "--height",     "36",          "--spp",         "64",
                                          "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = umbrameter(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.find(" reused, about ") != std::string::npos, reuses) << result.err;
    Json json = Json::parse(result.out, nullptr, false);
    json.erase("wall_time_s");
    return json;
  };
  const Json without = tune({"--out", "best", "--no-reuse"}, false);
  EXPECT_EQ(tune({"--out", "best"}, true), without);
  EXPECT_EQ(tune({"--out", "best", "--no-reuse"}, false), without);
}

TEST_F(GlTuneCommand, FindsTheLightsSizeAloneAndTogetherWithABias) {
  write_scene("scene.toml");
  for (const std::string parameters : {"light_size_scale", "light_size_scale,bias_texels"}) {
    const ProcessResult tuned =
        umbrameter({"tune", "scene.toml", "--technique",
                    "pcss:light_size_scale=3,bias_texels=8,filter_taps=64,search_taps=64,map_size=512",
                    "--parameters", parameters, "--evaluations", "40", "--cameras", "1", "--width", "160",
                    "--height", "90", "--spp", "64", "--out", "best", "--json"});
    ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
    const Json json = Json::parse(tuned.out);
    EXPECT_NEAR(std::log2(json["best"]["parameters"]["light_size_scale"].get<double>()), 0.0, 0.3)
        << parameters;
    const Json& given = json["light_size_sweep"][0];
    EXPECT_EQ(given["beside"], "given");
    ASSERT_TRUE(given["has_window"]) << parameters;
    EXPECT_LT(given["hard_free_from"], 1.0);
    EXPECT_GT(given["soft_free_to"], 1.0);
    EXPECT_LT(given["soft_free_to"], 3.0);
  }
}

TEST_F(TuneCommand, MistakesAreFoundBeforeAnythingIsRendered) {
  write_scene("scene.toml");
  const auto tune = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"tune", "scene.toml"});
    return umbrameter(arguments);
  };
  expect_bad_input(tune({"--technique", "pcf", "--parameters", "bias_texel"}), "did you mean 'bias_texels'?");
  expect_bad_input(tune({"--technique", "pcf", "--objective", "rsme"}), "unknown objective 'rsme'");
  expect_bad_input(tune({"--technique", "pcf", "--time-limit", "60"}), "--time-limit is '60', not a time");
}

TEST_F(TuneCommand, APresetFileIsChecked) {
  write_scene("scene.toml");
  const auto render = [&](const std::string& text) {
    write("preset.toml", text);
    return umbrameter({"render", "scene.toml", "--technique", "pcf", "--preset", "preset.toml"});
  };
  const std::string head = "technique = \"pcf\"\n[[preset]]\nname = \"mine\"\n";
  expect_bad_input(render("technique = \"vsm\"\n[[preset]]\nname = \"a\"\n[preset.values]\n"),
                   "preset.toml:1:13: this preset is for technique 'vsm', not 'pcf'");
  expect_bad_input(render(head + "[preset.values]\nbias_texel = 1\n"), "did you mean 'bias_texels'?");
  expect_bad_input(render(head + "[preset.values]\nbias_texels = 99\n"), "preset.toml:5:");
  expect_bad_input(render(head), "values");
  expect_bad_input(render("technique = \"pcf\"\n"), "one [[preset]]");
}

}  // namespace
}  // namespace umbrameter

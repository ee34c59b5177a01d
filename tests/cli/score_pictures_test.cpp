// SPDX-License-Identifier: Apache-2.0
// Without these, a picture could be misread without a word: its alpha multiplied in, its data window ignored, another part
// or a depth taken for visibility. Every reading of one picture must give that picture's own error.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class ScorePictures : public CliTest {
 protected:
  void SetUp() override {
    require_gl();
    if (IsSkipped()) return;
    const std::vector<std::string> size = {"--width", "96", "--height", "54"};
    make({"reference", "box_contact", "--spp", "64", "-o", "truth.exr"}, size);
    make({"render", "box_contact", "--technique", "pcf", "-o", "pcf.exr"}, size);
    oiio({"pcf.exr", "--ch", "visibility", "-o", "v.exr"});
    oiio({"v.exr", "--ch", "visibility,visibility,visibility", "--chnames", "R,G,B", "-o", "rgb.exr"});
    oiio({"truth.exr", "--ch", "unshadowed_irradiance,unshadowed_irradiance,unshadowed_irradiance",
          "--chnames", "R,G,B", "--mulc", "100", "-o", "unlit.exr"});
    oiio({"unlit.exr", "rgb.exr", "--mul", "-o", "lit.exr"});
  }

  void make(std::vector<std::string> arguments, const std::vector<std::string>& more) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = umbrameter(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  void oiio(const std::vector<std::string>& arguments) const {
    std::vector<std::string> command = {"oiiotool"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ProcessOptions options;
    options.working_folder = folder();
    const ProcessResult result = run_process(command, options);
    ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
  }

  ProcessResult score(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "score");
    for (const char* more : {"--reference", "truth.exr", "--metrics", "error,verdict"})
      arguments.emplace_back(more);
    return umbrameter(arguments);
  }

  Json scored(std::vector<std::string> arguments, int exit_code = 0) const {
    arguments.emplace_back("--json");
    const ProcessResult result = score(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return result.out.empty() ? Json() : Json::parse(result.out);
  }

  static double rmse(const Json& json) { return json["error"]["rmse"]["value"]; }
  static int64_t pixels(const Json& json) { return json["error"]["scored_pixels"]; }

  double right() const { return rmse(scored({"v.exr"})); }
};

TEST_F(ScorePictures, AlphaIsNeverMultipliedIn) {
  oiio({"rgb.exr", "--colorconvert", "linear", "sRGB", "-d", "uint8", "-o", "v8.png"});
  oiio({"rgb.exr", "--colorconvert", "linear", "sRGB", "--ch", "R,G,B,A=0", "--attrib",
        "oiio:UnassociatedAlpha", "1", "-d", "uint8", "-o", "a0.png"});
  const Json opaque = scored({"v8.png", "--transfer", "srgb"}),
             clear = scored({"a0.png", "--transfer", "srgb"});
  EXPECT_EQ(rmse(opaque), rmse(clear));
  EXPECT_NEAR(rmse(opaque), right(), 1e-3);
}

TEST_F(ScorePictures, APairWithAlphaOfFrameBuffersIsScored) {
  // Below 1, so that eight bits hold it.
  for (const std::string name : {"unlit", "lit"}) {
    oiio({name + ".exr", "--mulc", "0.1", "--colorconvert", "linear", "sRGB", "-d", "uint8", "-o",
          name + "8.png"});
    oiio({name + ".exr", "--mulc", "0.1", "--colorconvert", "linear", "sRGB", "--ch", "R,G,B,A=0", "--attrib",
          "oiio:UnassociatedAlpha", "1", "-d", "uint8", "-o", name + "_a0.png"});
  }
  const std::vector<std::string> how = {"--transfer", "srgb",         "--quantity",
                                        "visibility", "--min-scored", "0.5"};
  const auto pair = [&](const std::string& suffix) {
    std::vector<std::string> all = {"--shadowed", "lit" + suffix, "--unshadowed", "unlit" + suffix};
    all.insert(all.end(), how.begin(), how.end());
    return scored(all);
  };
  const Json opaque = pair("8.png"), clear = pair("_a0.png");
  EXPECT_EQ(rmse(opaque), rmse(clear));
  EXPECT_EQ(pixels(opaque), pixels(clear));
  EXPECT_GT(pixels(clear), 1000);
}

TEST_F(ScorePictures, DataWindowsArePlacedInTheDisplayWindow) {
  oiio({"v.exr", "--cut", "80x50+10+2", "--origin", "+10+2", "--fullsize", "96x54+0+0", "-o", "smaller.exr"});
  oiio({"v.exr", "--origin", "+6+0", "--fullsize", "96x54+0+0", "-o", "shifted.exr"});
  oiio({"v.exr", "--create", "112x70", "1", "--chnames", "visibility", "--paste", "+8+8", "--origin", "-8-8",
        "--fullsize", "96x54+0+0", "-o", "overscan.exr"});
  const Json whole = scored({"v.exr"});
  // All of it is there, and more.
  EXPECT_EQ(rmse(scored({"overscan.exr"})), rmse(whole));
  EXPECT_EQ(pixels(scored({"overscan.exr"})), pixels(whole));
  // What is missing is not scored, counted, and too much.
  const ProcessResult smaller = score({"smaller.exr"});
  EXPECT_EQ(smaller.exit_code, 1) << smaller.err;
  EXPECT_THAT(smaller.err, HasSubstr("outside the picture's data window"));
  EXPECT_THAT(smaller.err, HasSubstr("less than 95 %"));
  const Json part = scored({"smaller.exr", "--min-scored", "0.5"});
  EXPECT_LT(pixels(part), pixels(whole));
  EXPECT_LE(pixels(part), 80 * 50);
  EXPECT_EQ(part["scorable_pixels"], pixels(whole));
  // Six pixels to the right, and six columns missing: placed, so the shift is a fault that is seen.
  const Json shifted = scored({"shifted.exr", "--min-scored", "0.5"});
  EXPECT_LT(pixels(shifted), pixels(whole));
  EXPECT_GT(rmse(shifted), 1.5 * rmse(whole));
}

TEST_F(ScorePictures, PartsAndLayersAreFoundOrChosen) {
  oiio({"lit.exr", "v.exr", "--siappend", "-o", "multipart.exr"});
  oiio({"rgb.exr", "--chnames", "ViewLayer.Combined.R,ViewLayer.Combined.G,ViewLayer.Combined.B", "-o",
        "layer.exr"});
  const ProcessResult found = score({"multipart.exr", "--json"});
  EXPECT_EQ(rmse(Json::parse(found.out)), right());
  EXPECT_THAT(found.err, HasSubstr("the file also has 'R, G, B' of part 1"));
  EXPECT_EQ(rmse(scored({"multipart.exr", "--part", "2"})), right());
  expect_bad_input(score({"multipart.exr", "--part", "1"}), "visibility lies in 0 to 1");
  expect_bad_input(score({"multipart.exr", "--part", "3"}), "it has 2 parts");
  EXPECT_NEAR(rmse(scored({"layer.exr"})), right(), 1e-6);
  EXPECT_NEAR(rmse(scored({"layer.exr", "--channel", "Combined"})), right(), 1e-6);
  expect_bad_input(score({"layer.exr", "--channel", "Shadow"}), "ViewLayer.Combined.G");
}

TEST_F(ScorePictures, ADepthIsNoVisibilityUnlessItIsSaidToBe) {
  oiio({"v.exr", "--chnames", "Z", "-o", "z.exr"});
  expect_bad_input(score({"z.exr"}), "there is only Z");
  EXPECT_EQ(rmse(scored({"z.exr", "--channel", "Z"})), right());
}

TEST_F(ScorePictures, OneRuleHoldsForValuesJustOutside) {
  for (const std::string file : {"over.exr", "over.tif"}) {
    oiio({"v.exr", "--mulc", "1.0005", "-d", "float", "-o", file});
    const ProcessResult result = score({file, "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("outside [0, 1]: set to 0 or 1")) << file;
    EXPECT_NEAR(rmse(Json::parse(result.out)), right(), 1e-3) << file;
    oiio({"v.exr", "--mulc", "1.05", "-d", "float", "-o", file});
    expect_bad_input(score({file}), "visibility is 1.05");
  }
}

TEST_F(ScorePictures, AnInvertedPictureGetsAHint) {
  oiio({"v.exr", "--mulc", "-1", "--addc", "1", "-o", "inverted.exr"});
  EXPECT_THAT(score({"inverted.exr"}).err, HasSubstr("when it is inverted"));
  EXPECT_THAT(score({"v.exr"}).err, Not(HasSubstr("inverted")));
}

TEST_F(ScorePictures, ASwappedPairIsRefused) {
  expect_bad_input(score({"--shadowed", "unlit.exr", "--unshadowed", "lit.exr", "--limit", "0.05"}),
                   "swapped");
  const Json straight =
      scored({"--shadowed", "lit.exr", "--unshadowed", "unlit.exr", "--quantity", "visibility"});
  EXPECT_NEAR(rmse(straight), right(), 1e-4);
}

TEST_F(ScorePictures, AGateOnAPairAsksForItsQuantity) {
  expect_bad_input(score({"--shadowed", "lit.exr", "--unshadowed", "unlit.exr", "--limit", "0.5"}),
                   "--quantity");
  expect_bad_input(score({"--shadowed", "lit.exr", "--unshadowed", "unlit.exr", "--baseline", "v.exr"}),
                   "--quantity");
  const Json json = scored({"--shadowed", "lit.exr", "--unshadowed", "unlit.exr"});
  EXPECT_FALSE(json["quantity_given"]);
  EXPECT_FALSE(json["other_rmse"].is_null());
}

TEST_F(ScorePictures, ABaselineIsReadAsThePictureIs) {
  oiio({"rgb.exr", "--colorconvert", "linear", "sRGB", "-d", "uint8", "-o", "v8.png"});
  const Json same = scored({"v8.png", "--transfer", "srgb", "--baseline", "v8.png"});
  EXPECT_EQ(same["verdict"]["outcome"], "same");
  EXPECT_EQ(same["verdict"]["mse_difference"]["value"], 0.0);
}

TEST_F(ScorePictures, WorseThanTheBaselineFailsAndIsWrittenDown) {
  oiio({"v.exr", "--mulc", "0.7", "-o", "dark.exr"});
  const ProcessResult worse = score({"dark.exr", "--baseline", "v.exr", "-o", "out"});
  EXPECT_EQ(worse.exit_code, 1);
  EXPECT_THAT(worse.err, HasSubstr("worse than the baseline 'v.exr'"));
  std::ifstream file(folder() / "out" / "results.json");
  const Json runs = Json::parse(file)["scenes"][0]["techniques"];
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0]["verdict"]["outcome"], "worse");
  EXPECT_EQ(runs[0]["label"], "dark");
  EXPECT_EQ(runs[1]["label"], "v");
  EXPECT_EQ(score({"v.exr", "--baseline", "dark.exr"}).exit_code, 0);
}

TEST_F(ScorePictures, SeveralPicturesAreScoredAtOnce) {
  oiio({"v.exr", "--mulc", "0.7", "-o", "dark.exr"});
  const Json all = scored({"v.exr", "dark.exr"})["pictures"];
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(rmse(all[0]), right());
  EXPECT_EQ(all[1]["test"], "dark.exr");
  EXPECT_GT(rmse(all[1]), rmse(all[0]));
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these a verb could measure another moment than it was asked for, or say nothing of it.

#include "tests/cli/cli_fixture.h"
#include "tests/support/glb_file.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

const std::vector<std::string> kSmall{"--width", "48", "--height", "27", "--spp", "16"};

/// A square that slides over another one, to the right by 2 a second.
GlbFile sliding() {
  GlbFile file;
  file.add_square_mesh();
  file.json["nodes"] =
      Json::parse(R"([{"children": [1, 2], "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476]},
      {"mesh": 0, "scale": [6, 6, 1]}, {"name": "slider", "mesh": 0, "translation": [0, 2, 1]}])");
  file.animate(2, "translation", {0, 2}, {0, 2, 1, 4, 2, 1}, "VEC3", "LINEAR", 0, "slide");
  return file;
}

class Times : public CliTest {
 protected:
  void SetUp() override {
    write("x.glb", sliding().glb());
    GlbFile still = sliding();
    still.json.erase("animations");
    write("still.glb", still.glb());
    write("x.toml",
          "[camera]\neye = [3, 4, 5]\nat = [3, 0, -3]\n[[mesh]]\nfile = \"x.glb\"\n"
          "[[light]]\ntype = \"sun\"\ndirection = [0.3, -1, 0]\nangular_diameter_deg = 5\n");
  }
  ProcessResult small(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), kSmall.begin(), kSmall.end());
    return umbrameter(arguments);
  }
  Json check(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"scene", "check", "--json"});
    const ProcessResult result = umbrameter(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out)["scenes"][0] : Json();
  }
};

class GlTimes : public Times {
 protected:
  void SetUp() override {
    require_gl();
    Times::SetUp();
  }
};

TEST_F(Times, AreScenesOfTheirOwn) {
  const Json early = check({"x.glb", "--time", "0.5"}), late = check({"x.glb", "--time", "1"});
  EXPECT_EQ(early["name"], "x@0.5s");
  EXPECT_NE(early["hash"], late["hash"]);
  EXPECT_EQ(late["hash"], check({"x.glb", "--time", "1", "--animation", "slide"})["hash"]);
  EXPECT_EQ(check({"x.glb", "--time", "9"})["hash"], check({"x.glb", "--time", "2"})["hash"]);
  EXPECT_THAT(check({"x.glb", "--time", "9"})["warnings"].dump(), HasSubstr("beyond the last key"));
  EXPECT_THAT(check({"x.glb"})["warnings"].dump(), HasSubstr("1 animation is not shown ('slide')"));
  EXPECT_NE(check({"x.toml", "--time", "0.5"})["hash"], check({"x.toml"})["hash"]);
}

TEST_F(Times, ImportWritesTheTimeDown) {
  ASSERT_EQ(
      umbrameter({"scene", "import", "x.glb", "--time", "0.5", "--animation", "slide", "-o", "made.toml"})
          .exit_code,
      0);
  EXPECT_EQ(check({"made.toml"})["hash"], check({"x.glb", "--time", "0.5"})["hash"]);
  EXPECT_EQ(check({"made.toml"})["name"], "made");
}

TEST_F(Times, ThatCannotBeShownAreBadInput) {
  expect_bad_input(small({"reference", "still.glb", "--time", "1"}),
                   "it cannot be shown at 1 s: it has no animation");
  expect_bad_input(umbrameter({"scene", "import", "still.glb", "--time", "1"}), "it has no animation");
  write_scene("plain.toml");
  expect_bad_input(small({"reference", "plain.toml", "--time", "1"}), "it has no animation");
  expect_bad_input(small({"reference", "x.glb", "--time", "nan"}), "'nan' is not a number of seconds");
  expect_bad_input(small({"reference", "x.glb", "--animation", "slide"}), "--time");
  expect_bad_input(small({"reference", "x.glb", "--time", "1", "--animation", "glide"}),
                   "no animation is called 'glide'");
  expect_bad_input(umbrameter({"score", "x.exr", "--reference", "y.exr", "--time", "1"}),
                   "--time goes with --scene");
  EXPECT_THAT(files(), ElementsAre("plain.toml", "still.glb", "x.glb", "x.toml"));
}

TEST_F(GlTimes, AreInTheResultsAndKnownAgain) {
  const std::vector<std::string> first{"validate", "x.glb",  "--technique", "hard",  "--frames",
                                       "0",        "--time", "0.5",         "--json"};
  const ProcessResult run = small(first);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json results = Json::parse(run.out);
  const Json& scene = results["scenes"][0];
  EXPECT_EQ(scene["name"], "x@0.5s");
  EXPECT_EQ(scene["animated"],
            Json::parse(R"([{"mesh": "x", "file": "x.glb", "animation": "slide", "time_s": 0.5}])"));
  EXPECT_TRUE(scene["parity"]["passes"]);
  EXPECT_GE(scene["parity"]["agreement"], 0.995);
  const Json again = Json::parse(small(first).out);
  EXPECT_EQ(again["work"]["references_rendered"], 0);
  EXPECT_EQ(again["scenes"][0]["animated"], scene["animated"]);
  std::vector<std::string> other = first;
  other[7] = "1";
  const Json moved = Json::parse(small(other).out);
  EXPECT_EQ(moved["work"]["references_rendered"], 1) << "another moment is another scene";
  EXPECT_NE(moved["scenes"][0]["hash"], scene["hash"]);
}

TEST_F(GlTimes, AreFramesOfAStudy) {
  const std::string head = "schema = 1\ntitle = \"t\"\nscenes = [\"x.toml\"]\n";
  const std::string run =
      "width_px = 48\nheight_px = 27\nsamples_per_pixel = 16\n[[run]]\ntechnique = \"hard\"\n";
  write("study.toml", head + "time = [0, 0.5, 1]\nanimation = \"slide\"\n" + run);
  const ProcessResult plan = umbrameter({"plan", "study.toml", "--json"});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  std::vector<std::string> scenes;
  const Json planned = Json::parse(plan.out);
  for (const Json& step : planned["steps"]) {
    if (step["label"].is_null()) scenes.push_back(step["scene"]);
  }
  EXPECT_THAT(scenes, ElementsAre("x.toml@0s", "x.toml@0.5s", "x.toml@1s"));
  const ProcessResult swept = umbrameter({"sweep", "study.toml", "-o", "out", "--json"});
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  EXPECT_EQ(Json::parse(swept.out)["references_rendered"], 3);
  write("bad.toml", head + "time = [0, 0]\n" + run);
  expect_bad_input(umbrameter({"plan", "bad.toml"}), "bad.toml:4:12: the time 0 is given twice");
  write("bad.toml", head + "animation = \"slide\"\n" + run);
  expect_bad_input(umbrameter({"plan", "bad.toml"}), "'animation' goes with 'time'");
  write("bad.toml", head + "time = \"soon\"\n" + run);
  expect_bad_input(umbrameter({"plan", "bad.toml"}), "a time is no number of seconds");
  write_scene("plain.toml");
  write("bad.toml", "schema = 1\ntitle = \"t\"\nscenes = [\"plain.toml\"]\ntime = 1\n" + run);
  expect_bad_input(umbrameter({"plan", "bad.toml"}), "it has no animation");
}

}  // namespace
}  // namespace umbrameter

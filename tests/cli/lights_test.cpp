// SPDX-License-Identifier: Apache-2.0
// Without these tests a scene's second light could be ignored without a word, by any verb.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

const std::string kSun =
    "[[light]]\nname = \"sky\"\ntype = \"sun\"\ndirection = [0.3, -1, 0]\nangular_diameter_deg = 5\n";
const std::vector<std::string> kTiny{"--width", "48", "--height", "27", "--spp", "16"};

class Lights : public CliTest {
 protected:
  void SetUp() override { write_scene("two.toml", kSun); }

  ProcessResult tiny(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), kTiny.begin(), kTiny.end());
    return umbrameter(arguments);
  }
  std::string hash_of(const std::string& light) const {
    const ProcessResult result = tiny({"reference", "two.toml", "--light", light, "-o", "x.exr", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out)["scene_hash"] : "";
  }
};

class GlLights : public Lights {
 protected:
  void SetUp() override {
    require_gl();
    Lights::SetUp();
  }
  std::vector<std::string> scenes_of(const Json& results) const {
    std::vector<std::string> names;
    for (const Json& scene : results["scenes"]) names.push_back(scene["name"]);
    return names;
  }
};

TEST_F(Lights, VerbsOfOnePictureNeedAChoice) {
  const std::string message = "scene 'two.toml' has 2 lights: rect, sky (choose one with --light)";
  expect_bad_input(tiny({"reference", "two.toml"}), message);
  expect_bad_input(tiny({"render", "two.toml", "--technique", "hard"}), message);
  expect_bad_input(tiny({"scene", "export", "two.toml", "-o", "made"}), message);
  expect_bad_input(umbrameter({"score", "x.png", "--transfer", "srgb", "--scene", "two.toml"}), "x.png");
  expect_bad_input(umbrameter({"score", "x.exr", "--reference", "y.exr", "--light", "sky"}),
                   "--light goes with --scene");
  EXPECT_THAT(files(), ElementsAre("two.toml"));
}

TEST_F(Lights, AreChosenByNameOrNumber) {
  EXPECT_EQ(hash_of("sky"), hash_of("2"));
  EXPECT_NE(hash_of("sky"), hash_of("rect"));
  write_scene("one.toml");
  const Json one = Json::parse(tiny({"reference", "one.toml", "-o", "y.exr", "--json"}).out);
  EXPECT_EQ(hash_of("rect"), one["scene_hash"]) << "the truth of a file with that light alone";
  expect_bad_input(tiny({"reference", "two.toml", "--light", "sk"}),
                   "the scene has no light 'sk' (did you mean 'sky'?");
}

TEST_F(Lights, CheckAndPlanNameThemAll) {
  const ProcessResult check = umbrameter({"scene", "check", "two.toml"});
  EXPECT_THAT(check.out, HasSubstr("2 lights: rect 'rect', sun 'sky'"));
  const Json plan = Json::parse(umbrameter({"scene", "plan", "two.toml", "--json"}).out)["scenes"];
  ASSERT_EQ(plan.size(), 2u);
  EXPECT_EQ(plan[0]["name"], "two/rect");
  EXPECT_EQ(plan[1]["name"], "two/sky");
}

TEST_F(Lights, ShowLightsThePictureByAllOrOne) {
  EXPECT_THAT(umbrameter({"scene", "show", "two.toml", "-o", "all.png"}).out, HasSubstr("under 2 lights"));
  EXPECT_THAT(umbrameter({"scene", "show", "two.toml", "-o", "sky.png", "--light", "sky"}).out,
              HasSubstr("under 1 light\n"));
  EXPECT_THAT(files(), ElementsAre("all.png", "sky.png", "two.toml"));
  expect_bad_input(umbrameter({"scene", "show", "two.toml", "-o", "x.exr"}), ".png");
}

TEST_F(Lights, ImportedScenesCanBeEditedOrUsedAsTheyAre) {
  write("x.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}], "scene": 0,
    "nodes": [{"mesh": 0}, {"name": "lamp", "translation": [0, 0, 3], "extras": {"radius": 0.5},
               "extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const ProcessResult made = umbrameter({"scene", "import", "x.gltf", "-o", "sub/x.toml"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("it has no camera"));
  const Json own = Json::parse(umbrameter({"scene", "check", "x.gltf", "--json"}).out)["scenes"][0];
  const Json edited = Json::parse(umbrameter({"scene", "check", "sub/x.toml", "--json"}).out)["scenes"][0];
  EXPECT_EQ(own["triangles"], 1);
  EXPECT_EQ(own["hash"], edited["hash"]);
  EXPECT_EQ(own["lights"][0]["name"], "lamp");
  expect_bad_input(umbrameter({"scene", "import", "two.toml"}), "unknown format");
  expect_bad_input(umbrameter({"scene", "import", "gone.glb"}), "gone.glb");
}

TEST_F(GlLights, ValidateScoresEachAndKnowsEachAgain) {
  const std::vector<std::string> all{"validate", "two.toml", "--technique", "hard",
                                     "--frames", "0",        "--json"};
  const ProcessResult first = tiny(all);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const Json results = Json::parse(first.out);
  EXPECT_THAT(scenes_of(results), ElementsAre("two/rect", "two/sky"));
  EXPECT_NE(results["scenes"][0]["hash"], results["scenes"][1]["hash"]);
  EXPECT_EQ(results["work"]["references_rendered"], 2);
  const Json again = Json::parse(tiny(all).out);
  EXPECT_THAT(scenes_of(again), ElementsAre("two/rect", "two/sky"));
  EXPECT_EQ(again["work"]["references_rendered"], 0);
  std::vector<std::string> one = all;
  one.insert(one.end(), {"--light", "sky"});
  const Json sky = Json::parse(tiny(one).out);
  EXPECT_THAT(scenes_of(sky), ElementsAre("two/sky"));
  EXPECT_EQ(sky["scenes"][0]["hash"], results["scenes"][1]["hash"]);
  EXPECT_EQ(sky["work"]["references_rendered"], 0) << "the truth of that light is known";
}

TEST_F(GlLights, StudiesTakeAllOrTheirOwnChoice) {
  const std::string study =
      "schema = 1\ntitle = \"Lights\"\nscenes = [\"two.toml\"]\nwidth_px = 48\nheight_px = 27\n"
      "samples_per_pixel = 16\nframes = 1\n";
  const std::string run = "[[run]]\nlabel = \"hard\"\ntechnique = \"hard\"\n";
  write("all.toml", study + run);
  write("sky.toml", study + "light = \"sky\"\n" + run);
  EXPECT_THAT(scenes_of(Json::parse(umbrameter({"bench", "all.toml", "--json"}).out)),
              ElementsAre("two.toml/rect", "two.toml/sky"));
  EXPECT_THAT(scenes_of(Json::parse(umbrameter({"bench", "sky.toml", "--json"}).out)),
              ElementsAre("two.toml/sky"));
  EXPECT_THAT(scenes_of(Json::parse(umbrameter({"bench", "sky.toml", "--light", "1", "--json"}).out)),
              ElementsAre("two.toml/rect"));
}

}  // namespace
}  // namespace umbrameter

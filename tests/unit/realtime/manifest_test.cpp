// SPDX-License-Identifier: Apache-2.0
// Without these, a slip in a technique's folder would be measured instead of reported.

#include "realtime/manifest/activity.h"
#include "tests/unit/realtime/whole_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Manifest, LoadsWhatItSays) {
  TechniqueFolder folder;
  const Technique technique = load(folder, whole_manifest());
  EXPECT_EQ(technique.id, "tried");
  EXPECT_TRUE(technique.supports(LightType::sun));
  EXPECT_FALSE(technique.supports(LightType::disk));
  ASSERT_EQ(technique.parameters.size(), 4u);
  EXPECT_EQ(technique.parameters[0].stage, ParameterStage::define);
  ASSERT_EQ(technique.passes.size(), 2u);
  EXPECT_EQ(technique.passes[0].view, "light");
  ASSERT_TRUE(technique.passes[0].state.clear.has_value());
  EXPECT_EQ(*technique.passes[0].state.clear, std::vector<double>{0.0});
  EXPECT_EQ(technique.passes[1].reads, (std::vector<std::string>{"gbuffer.position", "shadow_map"}));
  ASSERT_EQ(technique.presets.size(), 1u);
  EXPECT_EQ(std::get<int64_t>(technique.presets[0].values.at("taps")), 64);
}

TEST(Manifest, UnknownKeysAreErrorsWithAHint) {
  EXPECT_THAT(error_after("fragment = ", "fragmnt = "), HasSubstr("did you mean 'fragment'?"));
  EXPECT_THAT(error_after("family = \"hard\"", "family = \"hard\"\nfamilly = 1"),
              AllOf(HasSubstr("technique.toml:6:"), HasSubstr("unknown key 'familly'"), HasSubstr("family")));
}

TEST(Manifest, SchemaMustBeKnown) {
  EXPECT_THAT(error_after("schema = 1", "schema = 2"),
              AllOf(HasSubstr("technique.toml:1:"), HasSubstr("schema")));
}

TEST(Manifest, UnknownLightTypeIsNamed) {
  EXPECT_THAT(error_after("\"rect\"", "\"rects\""),
              AllOf(HasSubstr("technique.toml:6:"), HasSubstr("'rects'"), HasSubstr("'rect'")));
  EXPECT_THAT(error_after("[\"rect\", \"sun\"]", "[]"), HasSubstr("no light type"));
}

TEST(Manifest, UnknownFormatAndStatesAreNamed) {
  EXPECT_THAT(error_after("depth32f", "depth32"), AllOf(HasSubstr("'depth32'"), HasSubstr("depth32f")));
  EXPECT_THAT(error_after("kind = \"fullscreen\"", "kind = \"screen\""),
              AllOf(HasSubstr("'screen'"), HasSubstr("kind")));
  EXPECT_THAT(error_after("clear = [0]", "clear = [0]\ncull = \"backs\""),
              AllOf(HasSubstr("'backs'"), HasSubstr("back")));
  EXPECT_THAT(error_after("clear = [0]", "clear = [0]\nblend = \"sum\""), HasSubstr("'sum'"));
  EXPECT_THAT(error_after("clear = [0]", "clear = [0, 0, 0, 0, 0]"), HasSubstr("1 to 4 numbers"));
  EXPECT_THAT(error_after("height = \"map_size\"", "height = \"map_size\"\nfilter = \"cubic\""),
              HasSubstr("'cubic'"));
  EXPECT_THAT(error_after("height = \"map_size\"", "height = \"map_size\"\nwrap = \"mirror\""),
              HasSubstr("'mirror'"));
}

TEST(Manifest, NamesMustServeAsIdentifiers) {
  EXPECT_THAT(error_after("name = \"light\"", "name = \"Light 1\""), HasSubstr("cannot be a name"));
  EXPECT_THAT(error_after("name = \"softness\"", "name = \"sample\""), HasSubstr("reserved word"));
}

TEST(Manifest, DuplicateNamesAreErrors) {
  EXPECT_THAT(error_after("name = \"softness\"", "name = \"taps\""),
              AllOf(HasSubstr("'taps'"), HasSubstr("parameter")));
  EXPECT_THAT(error_after("name = \"softness\"", "name = \"shadow_map\""),
              HasSubstr("resource 'shadow_map'"));
  EXPECT_THAT(error_after("id = \"resolve\"", "id = \"map\""),
              HasSubstr("pass 'map' stands here a second time"));
  EXPECT_THAT(error_after("reads = [\"gbuffer.position\"", "reads = [\"shadow_map\""),
              HasSubstr("reads 'shadow_map' twice"));
}

TEST(Manifest, ExpressionsAreCheckedAtLoad) {
  EXPECT_THAT(
      error_after("width = \"map_size\"", "width = \"map_sise\""),
      AllOf(HasSubstr("technique.toml:53:"), HasSubstr("unknown name 'map_sise'"), HasSubstr("'map_size'")));
  EXPECT_THAT(error_after("width = \"map_size\"", "width = \"map_size *\""), HasSubstr("unexpected end"));
  EXPECT_THAT(error_after("width = \"map_size\"", "width = 1.5"), HasSubstr("expression or an integer"));
  EXPECT_THAT(error_after("clear = [0]", "clear = [0]\ncondition = \"nope\""),
              HasSubstr("unknown name 'nope'"));
}

TEST(Manifest, ScreenAndLightAreKnownToExpressions) {
  TechniqueFolder folder;
  EXPECT_NO_THROW(
      load(folder, replaced(whole_manifest(), "width = \"map_size\"",
                            "width = \"light.type == light.sun ? map_size : ceil(screen.width / 2)\"")));
}

TEST(Manifest, ParametersSayWhenTheyAct) {
  const auto softness_when = [](const std::string& when) {
    return replaced(whole_manifest(), "doc = \"Softness.\"", "when = \"" + when + "\"\ndoc = \"Softness.\"");
  };
  TechniqueFolder folder;
  const Technique technique =
      load(folder, softness_when("taps > 4 && map_fit == map_fit.scene && light.type != light.sun"));
  const Parameter& softness = find_parameter(technique.parameters, "softness", "tried");
  ParameterValues values = default_values(technique.parameters);
  Light light;
  EXPECT_FALSE(is_active(technique, softness, values, light));
  values["taps"] = int64_t{5};
  EXPECT_TRUE(is_active(technique, softness, values, light));
  light.type = LightType::sun;
  EXPECT_FALSE(is_active(technique, softness, values, light));
  EXPECT_TRUE(is_active(technique, technique.parameters.front(), values, light));
  for (const std::string when : {"softness > 0", "tapes > 4", "screen.width > 4"})
    EXPECT_THAT(error_of(folder, softness_when(when)),
                AllOf(HasSubstr("parameter 'softness': unknown name"), HasSubstr(when)));
  EXPECT_THAT(error_of(folder, softness_when("taps >")), HasSubstr("unexpected end"));
}

TEST(Manifest, ChoicesAreKnownToExpressions) {
  TechniqueFolder folder;
  EXPECT_NO_THROW(load(folder, replaced(whole_manifest(), "clear = [0]",
                                        "clear = [0]\ncondition = \"map_fit == map_fit.scene\"")));
}

TEST(Manifest, UnreadParametersAreErrors) {
  TechniqueFolder folder;
  const auto adding = [](const std::string& name, const std::string& stage) {
    return replaced(whole_manifest(), "[[view]]",
                    "[[parameter]]\nname = \"" + name +
                        "\"\ntype = \"real\"\ndefault = 1\nmin = 0\nmax = 2\nstage = \"" + stage +
                        "\"\ndoc = \"x\"\n\n[[view]]");
  };
  EXPECT_THAT(error_of(folder, adding("spread", "define")),
              AllOf(HasSubstr("define parameter 'spread' is never read"), HasSubstr("SPREAD")));
  EXPECT_THAT(error_of(folder, adding("spread", "uniform")),
              HasSubstr("uniform parameter 'spread' is never read"));
  EXPECT_THAT(error_of(folder, adding("spread", "host")), HasSubstr("host parameter 'spread' is never read"));
  EXPECT_THAT(error_of(folder, adding("unused_in_comments", "uniform")), HasSubstr("is never read"));
  EXPECT_THAT(error_of(folder, replaced(adding("spread", "uniform"), "width = \"map_size\"",
                                        "width = \"map_size * spread\"")),
              HasSubstr("stage = \"host\""));
}

TEST(Manifest, PresetsMustFitTheParameters) {
  EXPECT_THAT(error_after("taps = 64", "tabs = 64"),
              AllOf(HasSubstr("preset 'fine' sets an unknown parameter 'tabs'"), HasSubstr("'taps'")));
  EXPECT_THAT(error_after("taps = 64", "taps = 65"),
              AllOf(HasSubstr("taps"), HasSubstr("65"), HasSubstr("range")));
  EXPECT_THAT(error_after("map_size = 1024", "map_size = 16"),
              AllOf(HasSubstr("preset 'fine'"), HasSubstr("taps <= map_size"), HasSubstr("taps = 64")));
}

TEST(Manifest, PresetValuesMustBeATable) {
  EXPECT_THAT(error_after("[preset.values]\nmap_size = 1024\ntaps = 64", "values = 3"),
              HasSubstr("[preset.values]"));
}

TEST(Manifest, DefaultsMustHoldTheConstraints) {
  EXPECT_THAT(error_after("taps <= map_size", "taps > map_size"),
              AllOf(HasSubstr("technique.toml:7:"), HasSubstr("the defaults"), HasSubstr("map_size = 32")));
  EXPECT_THAT(error_after("taps <= map_size", "taps <= screen.width"),
              HasSubstr("unknown name 'screen.width'"));
}

// A manifest with one letter wrong loads or is refused as bad input, never anything else.
TEST(Manifest, SlipsOfTheKeyboardNeverEscapeAsAnythingElse) {
  constexpr std::string_view kLetters = "aZ0.-_\"'[]{}=#,\n ";
  std::mt19937 random(1);
  TechniqueFolder folder;
  int loaded = 0;
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string manifest = whole_manifest();
    const size_t at = random() % manifest.size();
    if (trial % 2 == 0) {
      manifest[at] = kLetters[random() % kLetters.size()];
    } else {
      manifest.erase(at, 1 + random() % 20);
    }
    try {
      load(folder, manifest);
      ++loaded;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
      EXPECT_FALSE(error.where().file.empty()) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(loaded, 10);  // the walk reaches both outcomes
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace umbrameter

// Without these, a slip in a technique's folder would be measured instead of reported.

#include "core/files.h"
#include "realtime/manifest/technique.h"
#include "tests/support/technique_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::string_view kFragment = R"(// unused_in_comments
void main() { out_visibility = softness * float(TAPS) * texture(shadow_map, vec2(0.5)).r; }
)";

/// A manifest with one of everything. Its parameters: `taps` (define), `softness` (uniform), `map_size` and
/// `map_fit` (host).
std::string whole_manifest() {
  return manifest_head() + R"(constraints = ["taps <= map_size"]

[[parameter]]
name = "taps"
type = "integer"
default = 4
min = 1
max = 64
stage = "define"
doc = "Taps."

[[parameter]]
name = "softness"
type = "real"
default = 0.5
min = 0.0
max = 1.0
stage = "uniform"
doc = "Softness."

[[parameter]]
name = "map_size"
type = "integer"
default = 32
min = 16
max = 4096
stage = "host"
doc = "Map size."

[[parameter]]
name = "map_fit"
type = "choice"
choices = ["visible", "scene"]
default = "scene"
stage = "host"
doc = "Map fit."

[[view]]
name = "light"
from = "light.center"
fit = "map_fit"
size = "map_size"

[[resource]]
name = "shadow_map"
format = "depth32f"
width = "map_size"
height = "map_size"

[[pass]]
id = "map"
kind = "scene"
view = "light"
writes = ["shadow_map"]
clear = [0]

[[pass]]
id = "resolve"
kind = "fullscreen"
fragment = "resolve.frag"
views = ["light"]
reads = ["gbuffer.position", "shadow_map"]
writes = ["visibility"]

[[preset]]
name = "fine"
doc = "Fine."
[preset.values]
map_size = 1024
taps = 64
)";
}

Technique load(TechniqueFolder& folder, const std::string& manifest) {
  folder.write("technique.toml", manifest).write("resolve.frag", kFragment);
  return load_technique(folder.path(), folder.shared_folder(), TechniqueFolder::shaders_folder());
}

/// The message without the folder's path: "technique.toml:3:1: ...".
std::string error_of(TechniqueFolder& folder, const std::string& manifest) {
  try {
    load(folder, manifest);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_FALSE(error.where().file.empty()) << error.what();
    const std::string text = error.what();
    const size_t name = text.find("technique.toml");
    return name == std::string::npos ? text : text.substr(name);
  }
  return "no error";
}

std::string error_after(std::string_view from, std::string_view to) {
  TechniqueFolder folder;
  return error_of(folder, replaced(whole_manifest(), from, to));
}

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

TEST(Manifest, ChoicesAreKnownToExpressions) {
  TechniqueFolder folder;
  EXPECT_NO_THROW(load(folder, replaced(whole_manifest(), "clear = [0]",
                                        "clear = [0]\ncondition = \"map_fit == map_fit.scene\"")));
}

TEST(Manifest, ReadsMustHaveBeenWritten) {
  EXPECT_THAT(error_after("\"gbuffer.position\"", "\"gbuffer.positon\""),
              AllOf(HasSubstr("neither a resource nor built in"), HasSubstr("'gbuffer.position'")));
  EXPECT_THAT(error_after("\"gbuffer.position\"", "\"visibility\""),
              HasSubstr("reads and writes 'visibility'"));
  TechniqueFolder folder;
  std::string swapped = whole_manifest();
  const size_t map = swapped.find("[[pass]]");
  const size_t resolve = swapped.find("[[pass]]", map + 1);
  const size_t preset = swapped.find("[[preset]]");
  swapped = swapped.substr(0, map) + swapped.substr(resolve, preset - resolve) +
            swapped.substr(map, resolve - map) + swapped.substr(preset);
  EXPECT_THAT(error_of(folder, swapped),
              HasSubstr("pass 'resolve' reads 'shadow_map', which no earlier pass writes"));
}

TEST(Manifest, ResourcesMustBeReadAndWritten) {
  const std::string unused =
      "[[resource]]\nname = \"spare\"\nformat = \"r8\"\nwidth = 4\nheight = 4\n\n[[pass]]\nid = \"map\"";
  EXPECT_THAT(error_after("[[pass]]\nid = \"map\"", unused), HasSubstr("resource 'spare' is never written"));
  EXPECT_THAT(error_after("\"gbuffer.position\", \"shadow_map\"", "\"gbuffer.position\""),
              HasSubstr("resource 'shadow_map' is never read"));
  EXPECT_THAT(error_after("writes = [\"shadow_map\"]", "writes = [\"shadow_mpa\"]"),
              AllOf(HasSubstr("no resource"), HasSubstr("'shadow_map'")));
}

TEST(Manifest, DepthThatOnlyServesTheDepthTestNeedNotBeRead) {
  TechniqueFolder folder;
  folder.write("moments.frag", "void main() { out_moments = gl_FragCoord.z; }");
  std::string manifest =
      replaced(whole_manifest(), "[[pass]]\nid = \"map\"",
               "[[resource]]\nname = \"moments\"\nformat = \"r32f\"\nwidth = \"map_size\"\nheight = "
               "\"map_size\"\n\n[[pass]]\nid = \"map\"\nfragment = \"moments.frag\"");
  manifest = replaced(manifest, "writes = [\"shadow_map\"]", "writes = [\"moments\", \"shadow_map\"]");
  manifest = replaced(manifest, "\"gbuffer.position\", \"shadow_map\"", "\"moments\"");
  EXPECT_NO_THROW(load(folder, manifest));
}

TEST(Manifest, TargetsMustFitTheirPass) {
  EXPECT_THAT(error_after("writes = [\"visibility\"]", "writes = []"),
              HasSubstr("pass 'resolve' writes nothing"));
  EXPECT_THAT(error_after("writes = [\"shadow_map\"]", "writes = [\"visibility\"]"),
              HasSubstr("without a 'fragment' shader"));
  EXPECT_THAT(error_after("clear = [0]", ""),
              AllOf(HasSubstr("draws into 'shadow_map' before anything is in it"), HasSubstr("clear")));
  EXPECT_THAT(error_after("writes = [\"visibility\"]", "writes = [\"visibility\"]\nblend = \"add\""),
              HasSubstr("blends into 'visibility' before"));
  EXPECT_THAT(error_after("format = \"depth32f\"", "format = \"r32ui\"\ncompare = true"),
              HasSubstr("without a 'fragment'"));
}

TEST(Manifest, SamplersMustFitTheirFormat) {
  TechniqueFolder folder;
  folder.write("ids.frag", "void main() { out_ids = 1u; }");
  const std::string with_ids =
      replaced(replaced(whole_manifest(), "[[pass]]\nid = \"map\"",
                        "[[resource]]\nname = \"ids\"\nformat = \"r32ui\"\nwidth = 4\nheight = "
                        "4\nFILTER\n\n[[pass]]\nid = \"ids\"\nkind = \"fullscreen\"\nfragment = "
                        "\"ids.frag\"\nwrites = [\"ids\"]\n\n[[pass]]\nid = \"map\""),
               "\"gbuffer.position\", ", "\"ids\", ");
  EXPECT_EQ(error_of(folder, replaced(with_ids, "FILTER", "")), "no error");
  EXPECT_THAT(error_of(folder, replaced(with_ids, "FILTER", "filter = \"linear\"")),
              HasSubstr("cannot be filtered"));
  EXPECT_THAT(error_of(folder, replaced(with_ids, "FILTER", "compare = true")),
              HasSubstr("cannot be compared"));
}

TEST(Manifest, ViewsMustBeDeclaredAndUsed) {
  EXPECT_THAT(error_after("views = [\"light\"]", "views = [\"lihgt\"]"),
              AllOf(HasSubstr("which is not declared"), HasSubstr("'light'")));
  EXPECT_THAT(error_after("[[resource]]", "[[view]]\nname = \"other\"\nsize = 4\n\n[[resource]]"),
              HasSubstr("view 'other' is never used"));
  EXPECT_THAT(error_after("from = \"light.center\"", "from = \"light.centre\""), HasSubstr("'light.centre'"));
  EXPECT_THAT(error_after("fit = \"map_fit\"", "fit = \"tight\""), HasSubstr("unknown fit 'tight'"));
  EXPECT_THAT(error_after("fit = \"map_fit\"", "fit = \"taps\""), HasSubstr("cannot be a fit"));
}

TEST(Manifest, VisibilityMustBeWritten) {
  EXPECT_THAT(error_after("writes = [\"visibility\"]", R"(writes = ["copy"]

[[resource]]
name = "copy"
format = "r8"
width = 4
height = 4)"),
              HasSubstr("never writes 'visibility'"));
}

TEST(Manifest, ShaderFilesMustExist) {
  EXPECT_THAT(error_after("fragment = \"resolve.frag\"", "fragment = \"gone.frag\""),
              AllOf(HasSubstr("technique.toml:"), HasSubstr("'gone.frag' is missing")));
}

TEST(Manifest, LoopsNeedVariableCountAndBody) {
  const auto with_loop = [](const std::string& keys) {
    return replaced(whole_manifest(), "[[preset]]\nname",
                    "[[pass]]\nid = \"loop\"\nkind = \"loop\"\n" + keys + "\n\n[[preset]]\nname");
  };
  const std::string body =
      "\n[[pass.pass]]\nid = \"again\"\nkind = \"fullscreen\"\nfragment = \"resolve.frag\"\nreads = "
      "[\"shadow_map\"]\nwrites = [\"visibility\"]\nblend = \"add\"";
  TechniqueFolder folder;
  EXPECT_EQ(error_of(folder, with_loop("variable = \"i\"\ncount = \"taps\"" + body)), "no error");
  EXPECT_THAT(error_of(folder, with_loop("variable = \"i\"" + body)), HasSubstr("needs the key 'count'"));
  EXPECT_THAT(error_of(folder, with_loop("count = \"taps\"" + body)), HasSubstr("needs the key 'variable'"));
  EXPECT_THAT(error_of(folder, with_loop("variable = \"i\"\ncount = \"taps\"")),
              HasSubstr("at least one [[pass.pass]]"));
  EXPECT_THAT(error_of(folder, with_loop("variable = \"taps\"\ncount = 2" + body)),
              HasSubstr("uses the name 'taps'"));
  EXPECT_THAT(error_of(folder, with_loop("variable = \"i\"\ncount = \"i\"" + body)),
              HasSubstr("unknown name 'i'"));
}

TEST(Manifest, SampleViewsOfALoopStayInIt) {
  TechniqueFolder folder;
  std::string manifest = replaced(whole_manifest(), "from = \"light.center\"", "from = \"light.sample(i)\"");
  EXPECT_THAT(error_of(folder, manifest), HasSubstr("unknown name 'i'"));
  manifest =
      replaced(manifest, "[[preset]]\nname",
               "[[pass]]\nid = \"loop\"\nkind = \"loop\"\nvariable = \"i\"\ncount = 2\n[[pass.pass]]\nid = "
               "\"again\"\nkind = \"fullscreen\"\nfragment = \"resolve.frag\"\nreads = "
               "[\"shadow_map\"]\nwrites = [\"visibility\"]\n\n[[preset]]\nname");
  EXPECT_THAT(error_of(folder, manifest), HasSubstr("uses the view 'light' outside the loop over 'i'"));
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

TEST(Manifest, ParameterGroupsComeFromTheSharedFolder) {
  TechniqueFolder folder;
  folder.write_shared("bias.toml",
                      "[[parameter]]\nname = \"softness\"\ntype = \"real\"\ndefault = 0.25\nmin = 0\nmax = "
                      "1\nstage = \"uniform\"\ndoc = \"x\"\n");
  const std::string without =
      replaced(whole_manifest(),
               "[[parameter]]\nname = \"softness\"\ntype = \"real\"\ndefault = 0.5\nmin = 0.0\nmax = "
               "1.0\nstage = \"uniform\"\ndoc = \"Softness.\"\n",
               "");
  const Technique technique =
      load(folder, replaced(without, "constraints", "include = [\"bias\"]\nconstraints"));
  EXPECT_EQ(std::get<double>(default_values(technique.parameters).at("softness")), 0.25);
  EXPECT_THAT(error_of(folder, replaced(without, "constraints", "include = [\"bais\"]\nconstraints")),
              AllOf(HasSubstr("there is no shared manifest 'bais'"), HasSubstr("'bias'")));
}

TEST(Manifest, ParameterGroupsMayBeginWithOthersButNotWithThemselves) {
  TechniqueFolder folder;
  folder.write_shared("outer.toml",
                      "include = [\"inner\"]\n[[parameter]]\nname = \"softness\"\ntype = "
                      "\"real\"\ndefault = 0.25\nmin = 0\nmax = 1\nstage = \"uniform\"\ndoc = \"x\"\n");
  const std::string manifest =
      replaced(whole_manifest(),
               "[[parameter]]\nname = \"softness\"\ntype = \"real\"\ndefault = 0.5\nmin = 0.0\nmax = "
               "1.0\nstage = \"uniform\"\ndoc = \"Softness.\"\n",
               "");
  const std::string grouped = replaced(manifest, "constraints", "include = [\"outer\"]\nconstraints");
  folder.write_shared("inner.toml",
                      "[[parameter]]\nname = \"unused\"\ntype = \"boolean\"\ndefault = true\nstage = "
                      "\"host\"\ndoc = \"x\"\n");
  EXPECT_THAT(error_of(folder, grouped), HasSubstr("host parameter 'unused' is never read"));
  folder.write_shared("inner.toml", "include = [\"outer\"]\n");
  EXPECT_THAT(error_of(folder, grouped),
              AllOf(HasSubstr("inner.toml:1"), HasSubstr("'outer' comes in a second time")));
}

TEST(Manifest, HashCoversManifestShadersAndGroupsButNotThePlace) {
  TechniqueFolder a;
  TechniqueFolder b;
  const std::string hash = load(a, whole_manifest()).hash;
  EXPECT_EQ(load(b, whole_manifest()).hash, hash);
  EXPECT_NE(load(b, replaced(whole_manifest(), "default = 4", "default = 5")).hash, hash);
  load(b, whole_manifest());
  b.write("resolve.frag", std::string(kFragment) + "// changed\n");
  EXPECT_NE(load_technique(b.path(), b.shared_folder(), TechniqueFolder::shaders_folder()).hash, hash);
}

TEST(Techniques, AreListedWithoutTheSharedFolder) {
  TechniqueFolder folder;
  load(folder, whole_manifest());
  folder.write_shared("bias.toml", "");
  const auto techniques = list_techniques(folder.techniques_folder(), TechniqueFolder::shaders_folder());
  ASSERT_EQ(techniques.size(), 1u);
  EXPECT_EQ(techniques[0].id, "tried");
}

TEST(Techniques, AreFoundByIdAndByPath) {
  TechniqueFolder folder;
  load(folder, whole_manifest());
  const auto found = [&](const std::string& name) {
    return find_technique(name, folder.techniques_folder(), TechniqueFolder::shaders_folder()).id;
  };
  EXPECT_EQ(found("tried"), "tried");
  EXPECT_EQ(found(folder.path().string()), "tried");
  try {
    found("treid");
    FAIL() << "found a technique that is not there";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no technique 'treid'"), HasSubstr("'tried'")));
  }
}

TEST(Parameters, ResolveDefaultsThenPresetThenOverrides) {
  TechniqueFolder folder;
  const Technique technique = load(folder, whole_manifest());
  const ParameterValues values =
      resolve_parameters(technique, {{"preset", std::string("fine")}, {"taps", int64_t{8}}});
  EXPECT_EQ(std::get<int64_t>(values.at("taps")), 8);         // override
  EXPECT_EQ(std::get<int64_t>(values.at("map_size")), 1024);  // preset
  EXPECT_EQ(std::get<double>(values.at("softness")), 0.5);    // default
}

TEST(Parameters, BadOverridesAreErrors) {
  TechniqueFolder folder;
  const Technique technique = load(folder, whole_manifest());
  const auto error = [&](const ParameterValues& overrides) -> std::string {
    try {
      resolve_parameters(technique, overrides);
    } catch (const Error& caught) {
      return caught.what();
    }
    return "no error";
  };
  EXPECT_THAT(error({{"tabs", int64_t{1}}}), AllOf(HasSubstr("no parameter 'tabs'"), HasSubstr("'taps'")));
  EXPECT_THAT(error({{"taps", int64_t{65}}}), HasSubstr("range"));
  EXPECT_THAT(error({{"taps", 1.5}}), HasSubstr("an integer"));
  EXPECT_THAT(error({{"preset", std::string("fin")}}),
              AllOf(HasSubstr("no preset 'fin'"), HasSubstr("'fine'")));
  EXPECT_THAT(error({{"taps", int64_t{64}}}), HasSubstr("taps <= map_size"));
}

TEST(Parameters, IntegersServeForRealParameters) {
  TechniqueFolder folder;
  const ParameterValues values =
      resolve_parameters(load(folder, whole_manifest()), {{"softness", int64_t{1}}});
  EXPECT_EQ(std::get<double>(values.at("softness")), 1.0);
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

// Every technique of ours must pass its own checks.
TEST(Techniques, OfTheLibraryLoad) {
  const auto realtime = std::filesystem::path(UMBRAMETER_SOURCE_DIR) / "realtime";
  EXPECT_GE(list_techniques(realtime / "techniques").size(), 4u);
}

}  // namespace
}  // namespace umbrameter

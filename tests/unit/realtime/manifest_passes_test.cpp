// SPDX-License-Identifier: Apache-2.0
// What passes read, write and draw must fit together before anything is drawn.

#include "tests/unit/realtime/whole_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

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

std::string manifest_with_depth_bits(const std::string& choices) {
  const std::string parameter = "[[parameter]]\nname = \"bits\"\ntype = \"choice\"\nchoices = " + choices +
                                "\ndefault = \"depth32f\"\nstage = \"host\"\ndoc = \"Bits.\"\n\n[[view]]";
  return replaced(replaced(whole_manifest(), "[[view]]", parameter), "format = \"depth32f\"",
                  "format = \"bits\"");
}

TEST(Manifest, AFormatMayBeAParameter) {
  TechniqueFolder folder;
  const ResourceDeclaration map =
      load(folder, manifest_with_depth_bits("[\"depth16\", \"depth32f\"]")).resources.front();
  EXPECT_EQ(map.format({{"bits", 0.0}}), "depth16");
  EXPECT_EQ(map.format({{"bits", 1.0}}), "depth32f");
  EXPECT_THAT(error_of(folder, manifest_with_depth_bits("[\"depth61\", \"depth32f\"]")),
              HasSubstr("unknown texture format 'depth61'"));
  EXPECT_THAT(error_of(folder, manifest_with_depth_bits("[\"r32f\", \"depth32f\"]")),
              HasSubstr("shaders read in two ways"));
  EXPECT_THAT(error_after("format = \"depth32f\"", "format = \"softness\""),
              HasSubstr("parameter 'softness' cannot be a format"));
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

constexpr std::string_view kFamily = "name = \"light\"\ncount = 3\nvariable = \"k\"\nfrom = \"light.center\"";

TEST(Manifest, PassesSayWhichOfAFamilyOfViewsTheyDrawFrom) {
  TechniqueFolder folder;
  const std::string family =
      replaced(whole_manifest(), "name = \"light\"\nfrom = \"light.center\"", std::string(kFamily));
  EXPECT_THAT(error_of(folder, family),
              AllOf(HasSubstr("pass 'map' draws from the views 'light' and does not say from which"),
                    HasSubstr("view_index")));
  EXPECT_EQ(error_of(folder, replaced(family, "view = \"light\"", "view = \"light\"\nview_index = 2")),
            "no error");
  EXPECT_THAT(error_of(folder, replaced(family, "view = \"light\"",
                                        "view = \"light\"\nview_index = 2\nviews = [\"light\"]")),
              HasSubstr("lists them all in 'views'"));
  EXPECT_THAT(error_after("view = \"light\"", "view = \"light\"\nview_index = 0"),
              HasSubstr("has a 'view_index', but 'light' is a single view"));
  EXPECT_THAT(error_of(folder, replaced(family, "variable = \"k\"", "variable = \"taps\"")),
              HasSubstr("'taps' means something else already"));
  EXPECT_THAT(error_of(folder, replaced(family, "variable = \"k\"\n", "")), HasSubstr("variable"));
}

TEST(Manifest, FacesAndSlicesFitTheirLights) {
  EXPECT_THAT(error_after("from = \"light.center\"\nfit = \"map_fit\"", "from = \"light.face(0)\""),
              HasSubstr("looks all around the light, which a sun has no place for"));
  EXPECT_THAT(error_after("from = \"light.center\"", "from = \"light.face(0)\""),
              AllOf(HasSubstr("a view all around the light has no 'fit'"), HasSubstr("leave it out")));
  EXPECT_THAT(error_after("from = \"light.center\"", "from = \"light.side(0)\""),
              HasSubstr("light.face(<expression>)"));
  EXPECT_THAT(error_after("size = \"map_size\"\n\n[[resource]]",
                          "slice_world = [0, 1]\nsize = \"map_size\"\n\n[[resource]]"),
              HasSubstr("covers a slice of the frustum, which only a sun's can"));
  EXPECT_THAT(error_after("size = \"map_size\"\n\n[[resource]]",
                          "slice_world = [0]\nsize = \"map_size\"\n\n[[resource]]"),
              HasSubstr("'slice_world' must be a list of two expressions"));
  EXPECT_THAT(error_after("choices = [\"visible\", \"scene\"]", "choices = [\"scene\", \"sphere\"]"),
              HasSubstr("has the fit 'sphere' without a slice"));
}

TEST(Manifest, LayersAreWrittenOneByOne) {
  const auto with = [](const std::string& resource, const std::string& pass) {
    TechniqueFolder folder;
    std::string manifest = replaced(whole_manifest(), "format = \"depth32f\"", resource);
    return error_of(folder,
                    replaced(manifest, "writes = [\"shadow_map\"]", "writes = [\"shadow_map\"]\n" + pass));
  };
  const std::string array = "format = \"depth32f\"\nkind = \"array\"\nlayers = 2";
  EXPECT_EQ(with(array, "write_layer = 1"), "no error");
  EXPECT_EQ(with("format = \"depth32f\"\nkind = \"cube\"", "write_layer = 5"), "no error");
  EXPECT_THAT(with(array, ""), HasSubstr("writes 'shadow_map' and does not say which layer"));
  EXPECT_THAT(with("format = \"depth32f\"", "write_layer = 0"),
              HasSubstr("has a 'write_layer', but writes nothing with layers"));
  EXPECT_THAT(with("format = \"depth32f\"\nkind = \"array\"", "write_layer = 0"), HasSubstr("layers"));
  EXPECT_THAT(with("format = \"depth32f\"\nkind = \"cube\"\nlayers = 6", "write_layer = 0"),
              AllOf(HasSubstr("only kind = \"array\" has 'layers'"), HasSubstr("six")));
  EXPECT_THAT(with("format = \"depth32f\"\nkind = \"3d\"", "write_layer = 0"), HasSubstr("3d"));
}

TEST(Manifest, ValuesAreUsedAndNamedOnce) {
  const auto with = [](const std::string& value, const std::string& width) {
    TechniqueFolder folder;
    const std::string manifest = replaced(whole_manifest(), "[[view]]", "[[value]]\n" + value + "\n[[view]]");
    return error_of(folder, replaced(manifest, "width = \"map_size\"", "width = \"" + width + "\""));
  };
  EXPECT_EQ(with("name = \"side\"\nvalue = \"2 * map_size\"", "side"), "no error");
  EXPECT_THAT(with("name = \"side\"\nvalue = \"2 * map_size\"", "map_size"),
              HasSubstr("value 'side' is never used"));
  EXPECT_THAT(with("name = \"taps\"\nvalue = 2", "map_size"),
              HasSubstr("'taps' means something else already"));
  EXPECT_THAT(with("name = \"side\"\nvalue = \"2 * side\"", "side"), HasSubstr("unknown name 'side'"));
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

}  // namespace
}  // namespace umbrameter

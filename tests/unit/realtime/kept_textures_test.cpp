// SPDX-License-Identifier: Apache-2.0
// Without these, a pass could be left out whose texture nobody kept, or shaders be told apart by what they never name.

#include "realtime/executor/kept_textures.h"

#include "realtime/harness/shader_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using Known = std::map<std::string, std::shared_ptr<const Texture>>;

Known known(std::initializer_list<const char*> names) {
  Known textures;
  for (const char* name : names) textures[name] = nullptr;  // which one it is does not matter here
  return textures;
}

std::vector<std::string> names_of(const Known& textures) {
  std::vector<std::string> names;
  for (const auto& [name, texture] : textures) names.push_back(name);
  return names;
}

/// A map, its two blurs, and who reads the second.
RunContents blurred() {
  return {{{0, {}, {{"map", "0"}}},
           {1, {{"map", "1"}}, {{"half", "0"}}},
           {2, {{"half", "1"}}, {{"blurred", "0"}}},
           {3, {{"blurred", "1"}}, {{"visibility", "0"}}}},
          {{"map", "1"}, {"half", "1"}, {"blurred", "1"}, {"visibility", "1"}}};
}

TEST(NeededSteps, BeginAfterTheLastTextureThatIsThere) {
  Known nothing;
  EXPECT_THAT(needed_steps(blurred(), nothing), ElementsAre(true, true, true, true));
  Known map = known({"map"});
  EXPECT_THAT(needed_steps(blurred(), map), ElementsAre(false, true, true, true));
  Known all = known({"blurred", "half", "map"});
  EXPECT_THAT(needed_steps(blurred(), all), ElementsAre(false, false, false, true));
  EXPECT_EQ(all.size(), 3u);
}

TEST(NeededSteps, ATextureIsNoGoodToWhoReadsItBeforeItsLastChange) {
  // Maps of two samples of a light, drawn into one texture and added up.
  const RunContents sum = {{{0, {}, {{"map", "0"}}},
                            {1, {{"map", "1"}}, {{"visibility", "0"}}},
                            {2, {}, {{"map", "1"}}},
                            {3, {{"map", "2"}}, {{"visibility", "1"}}}},
                           {{"map", "2"}, {"visibility", "2"}}};
  Known map = known({"map"});
  EXPECT_THAT(needed_steps(sum, map), ElementsAre(true, true, true, true));
  EXPECT_TRUE(map.empty());
}

TEST(NeededSteps, APassOfTwoTargetsIsDrawnForTheOneThatIsMissing) {
  const RunContents pair = {{{0, {}, {{"depth", "0"}, {"moments", "0"}}},
                             {1, {{"depth", "1"}, {"moments", "1"}}, {{"visibility", "0"}}}},
                            {{"depth", "1"}, {"moments", "1"}, {"visibility", "1"}}};
  Known moments = known({"moments"});
  EXPECT_THAT(needed_steps(pair, moments), ElementsAre(true, true));
  EXPECT_TRUE(moments.empty());
  Known both = known({"depth", "moments"});
  EXPECT_THAT(needed_steps(pair, both), ElementsAre(false, true));
  EXPECT_THAT(names_of(both), ElementsAre("depth", "moments"));
}

TEST(NeededSteps, WhatAPassDrawsOverIsWantedToo) {
  const RunContents over = {
      {{0, {}, {{"mask", "0"}}}, {1, {}, {{"mask", "1"}}}, {2, {{"mask", "2"}}, {{"visibility", "0"}}}},
      {{"mask", "2"}, {"visibility", "1"}}};
  Known nothing;
  EXPECT_THAT(needed_steps(over, nothing), ElementsAre(true, true, true));
}

TEST(ShaderWords, AnInputThatIsDeclaredAndReadStandsTwice) {
  EXPECT_THAT(repeated_words("float bias; float scale_1; void main() { out_v = bias + scale_1 + scale; }"),
              ElementsAre("bias", "float", "scale_1"));
}

TEST(ShaderWords, MacrosThatNobodyNamesAreLeftOutAndLinesStayWhereTheyAre) {
  EXPECT_EQ(without_idle_macros("#define TAPS 16\n#define BILINEAR 1\nfloat v = float(TAPS);\n"),
            "#define TAPS 16\n\nfloat v = float(TAPS);\n");
  for (const std::string kept :
       {"#define TAPS 16\n#if TAPS > 4\n#endif", "#define A B\n#define B 1\nint x = A;",
        "#define LONG 1 + \\\n 2", "#define OPEN /*\n*/ 1"}) {
    EXPECT_EQ(without_idle_macros(kept), kept);
  }
}

}  // namespace
}  // namespace umbrameter

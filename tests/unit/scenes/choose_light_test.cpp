// SPDX-License-Identifier: Apache-2.0
// Without these: a scene's second light could be ignored, or two lights' truths could be taken for one another.
#include "scenes/choose_light.h"

#include "scene_text.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;

const std::string kLamp = "type = \"disk\"\ncenter = [0, 3, 0]\ndirection = [0, -1, 0]\nradius = 0.5";
const std::string kSun = "type = \"sun\"\ndirection = [0, -1, 0]\nangular_diameter_deg = 1";

Scene lit(const std::string& light) {
  return SceneText{.light = light}.parse();
}

const Scene kTwo = lit(kLamp + "\nname = \"lamp\"\n[[light]]\n" + kSun);

TEST(ChooseLight, ByNameThenByNumber) {
  EXPECT_EQ(find_light(kTwo.lights, "lamp"), 0u);
  EXPECT_EQ(find_light(kTwo.lights, "sun"), 1u);
  EXPECT_EQ(find_light(kTwo.lights, "2"), 1u);
  const Scene swapped = lit(kLamp + "\nname = \"2\"\n[[light]]\n" + kSun);
  EXPECT_EQ(find_light(swapped.lights, "2"), 0u) << "a name comes before a number";
}

TEST(ChooseLight, UnknownOnesAreErrorsWithTheNames) {
  EXPECT_EQ(message_of([] { find_light(kTwo.lights, "lmap"); }),
            "the scene has no light 'lmap' (did you mean 'lamp'?; numbers go from 1 to 2)");
  for (const std::string text : {"0", "3", "-1", "1x", ""})
    EXPECT_THAT(message_of([&] { find_light(kTwo.lights, text); }),
                testing::HasSubstr("numbers go from 1 to 2"));
}

TEST(ChooseLight, EmptyTextChoosesAll) {
  EXPECT_THAT(choose_lights(kTwo.lights, ""), ElementsAre(0u, 1u));
  EXPECT_THAT(choose_lights(kTwo.lights, "sun"), ElementsAre(1u));
}

TEST(ChooseLight, OnlySeveralLightsMakeALongerName) {
  EXPECT_EQ(lit_name("x", kTwo.lights, 1), "x/sun");
  EXPECT_EQ(lit_name("x", lit(kSun).lights, 0), "x");
}

TEST(ChooseLight, AViewIsTheSceneOfAFileWithThatLightAlone) {
  const Scene sun = lit_by(kTwo, 1);
  ASSERT_EQ(sun.lights.size(), 1u);
  EXPECT_EQ(sun.light().name, "sun");
  EXPECT_EQ(sun.hash, lit(kSun).hash);
  EXPECT_EQ(lit_by(kTwo, 0).hash, lit(kLamp).hash);
  EXPECT_NE(sun.hash, lit_by(kTwo, 0).hash);
  EXPECT_NE(sun.hash, kTwo.hash);
  const Scene alone = lit(kSun);
  EXPECT_EQ(lit_by(alone, 0).hash, alone.hash);
}

TEST(ChooseLight, LightsWithoutANameAreNumberedByType) {
  const Scene scene =
      lit(kSun + "\n[[light]]\n" + kSun + "\n[[light]]\n" + kSun + "\nname = \"sun-2\"\n[[light]]\n" + kLamp);
  std::vector<std::string> names;
  for (const Light& light : scene.lights) names.push_back(light.name);
  EXPECT_THAT(names, ElementsAre("sun", "sun-3", "sun-2", "disk"));
}

}  // namespace
}  // namespace umbrameter

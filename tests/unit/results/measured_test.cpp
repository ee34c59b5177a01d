// SPDX-License-Identifier: Apache-2.0
// Without these, a verb could pass that has measured nothing, or fail one that has measured enough.

#include "results/measured.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Unmeasured, NeedsAShareOfWhatTheTruthCanScore) {
  EXPECT_FALSE(unmeasured(95, 100));
  EXPECT_THAT(unmeasured(94, 100).value(), HasSubstr("only 94 % of the 100 pixels"));
  EXPECT_FALSE(unmeasured(94, 100, 0.9));
  EXPECT_THAT(unmeasured(0, 100, 0.0).value(), HasSubstr("none of the 100 pixels"));
  EXPECT_THAT(unmeasured(0, 0, 0.0).value(), HasSubstr("can score no pixel"));
}

MeasuredScene scene_with(std::vector<std::pair<std::string, size_t>> scored) {
  MeasuredScene scene;
  scene.name = "plate";
  scene.scorable_pixels = 100;
  scene.scored_pixels = std::move(scored);
  scene.why_none = "there is no run";
  return scene;
}

TEST(Unmeasured, NamesTheSceneAndTheRun) {
  EXPECT_THAT(unmeasured(std::vector{scene_with({{"pcf", 100}, {"hard", 10}})}),
              ElementsAre(HasSubstr("plate, hard: not measured: only 10 %")));
  EXPECT_THAT(unmeasured(std::vector{scene_with({{"pcf", 100}})}), IsEmpty());
  EXPECT_THAT(unmeasured(std::vector{scene_with({})}),
              ElementsAre("plate: nothing was measured: there is no run"));
  EXPECT_THAT(unmeasured(std::vector<MeasuredScene>{}), ElementsAre(HasSubstr("there is no scene")));
}

TEST(Unmeasured, DoesNotRepeatWhatAFailureSays) {
  MeasuredScene failed = scene_with({});
  failed.is_told = true;
  EXPECT_THAT(unmeasured(std::vector{failed}), IsEmpty());
}

TEST(Unmeasured, SaysWhyAValidationsSceneHasNone) {
  Results results;
  SceneResult scene;
  scene.name = "plate";
  results.scenes.push_back(scene);
  EXPECT_THAT(unmeasured(measured_scenes(results)), ElementsAre(HasSubstr("there is no run")));
  results.skipped.push_back({"plate", "planar", "does not support sphere lights"});
  EXPECT_THAT(unmeasured(measured_scenes(results)),
              ElementsAre("plate: nothing was measured: 'planar' does not support sphere lights"));
  results.skipped.push_back({"plate", "", "the light reaches nothing in the picture"});
  EXPECT_THAT(unmeasured(measured_scenes(results)), ElementsAre(HasSubstr("the light reaches nothing")));
}

}  // namespace
}  // namespace umbrameter

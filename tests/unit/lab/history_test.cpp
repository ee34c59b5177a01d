// SPDX-License-Identifier: Apache-2.0
// Without these the rows of history could be measured of techniques that carry none, from the wrong pictures, or be taken for
// those of another motion.
#include "lab/history.h"

#include "lab/keys.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace umbrameter {
namespace {

/// Draws a run of eight frames: .2 off after one, .1 after two, .05 after more; and `trail` more where something moved.
class HistoryRenderer final : public Renderer {
 public:
  Frame render(const Scene& scene, const RenderRequest&, Progress&) override {
    const int before = scene.motion.frames_before.value_or(7);
    const bool has_moved = scene.motion.name != Motion{}.name;
    const float error = before == 0 ? 0.2f : before == 1 ? 0.1f : 0.05f;
    Frame frame = frame_of(technique_image(has_moved ? error + 0.1f : error));
    frame.frames_before = has_history ? before : 0;
    if (has_history) frame.motion = scene.motion.name;
    befores.push_back(before);
    return frame;
  }
  bool has_history = true;
  std::vector<int> befores;
};

TechniqueResult validated(HistoryRenderer& realtime, const std::string& motion) {
  const TemporaryFolder folder;
  FakeRenderer reference = fake_reference();
  const std::vector<SceneJob> scenes{fake_scene("plate")};
  SilentProgress progress;
  ValidationPlan plan = fake_plan({fake_technique("tried")});
  plan.motion = motion;
  plan.timed_frames = 0;
  const Results results = run_validation(scenes, plan, {reference, realtime}, folder.path(), progress);
  EXPECT_EQ(reference.requests.size(), 1u) << "the truth is of the last frame, whatever moved";
  return results.scenes.at(0).techniques.at(0);
}

TEST(HistoryMeasures, AreOfTheSameFrameWhereNothingMoved) {
  HistoryRenderer realtime;
  const TechniqueResult run = validated(realtime, "pan");
  EXPECT_EQ(run.frames_before, 7);
  EXPECT_EQ(run.motion, "pan");
  // Columns 1 to 19 of 1 to 39 are off.
  const double share = 19.0 / 39.0;
  EXPECT_NEAR(run.measured.at("ghosting"), std::sqrt(share * (0.15 * 0.15 - 0.05 * 0.05)), 1e-5);
  // Nine tenths of .15 are mended at .065: between 2 and 4 frames.
  EXPECT_NEAR(run.measured.at("convergence_frames"), 2.0 * std::pow(2.0, (0.1 - 0.065) / 0.05), 1e-3);
}

TEST(HistoryMeasures, HaveNoTrailWhereNothingMoves) {
  HistoryRenderer realtime;
  const TechniqueResult run = validated(realtime, "still");
  EXPECT_EQ(run.motion, "still");
  EXPECT_FALSE(run.measured.contains("ghosting"));
  EXPECT_TRUE(run.measured.contains("convergence_frames"));
}

TEST(HistoryMeasures, AreForTechniquesWithHistoryThatAreAskedFor) {
  HistoryRenderer realtime;
  realtime.has_history = false;
  EXPECT_FALSE(validated(realtime, "pan").measured.contains("convergence_frames"));
  EXPECT_EQ(realtime.befores.size(), 2u);  // surfaces and the run
  realtime.has_history = true;
  EXPECT_FALSE(validated(realtime, "").measured.contains("convergence_frames"));
}

TEST(HistoryMeasures, StandUnderTheMotion) {
  EXPECT_EQ(moved_run_key("run", ""), "run");
  EXPECT_NE(moved_run_key("run", "pan"), "run");
  EXPECT_NE(moved_run_key("run", "pan"), moved_run_key("run", "cut"));
}

}  // namespace
}  // namespace umbrameter

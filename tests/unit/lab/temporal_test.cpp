// SPDX-License-Identifier: Apache-2.0
// Without these a sequence could leave the results.
#include "lab/temporal.h"

#include "results/json/results_json.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <cmath>

namespace umbrameter {
namespace {

TEST(Temporal, IsMeasuredOnceAskedAndSurvivesTheFile) {
  const TemporaryFolder folder;
  int frames = 0;
  FakeRenderer reference = fake_reference();
  // A level that differs from frame to frame: it pops by .02 a frame.
  FakeRenderer realtime(
      [&](const RenderRequest&) { return frame_of(technique_image(0.02f * (frames++ % 2))); });
  const std::vector<SceneJob> scenes{fake_scene("plate")};
  SilentProgress progress;
  ValidationPlan plan = fake_plan({fake_technique("noisy")});
  plan.temporal_frames = 3;
  const Results results = run_validation(scenes, plan, {reference, realtime}, folder.path(), progress);
  const TechniqueResult& run = results.scenes.at(0).techniques.at(0);
  ASSERT_TRUE(run.temporal) << (run.warnings.empty() ? "" : run.warnings[0]);
  EXPECT_EQ(run.temporal->frames, 3);
  // Columns 1 to 19 of 1 to 39 change by .02 a step.
  EXPECT_NEAR(*run.temporal->light.rms, 0.02 * std::sqrt(19.0 / 39.0), 1e-5);
  EXPECT_GT(*run.temporal->seed_noise, 0.0);
  EXPECT_EQ(reference.requests.size(), 1u + 2u + 2u);  // the truth, two more frames a motion

  const std::string text = to_json_text(results);
  EXPECT_EQ(to_json_text(parse_results(text, "results.json")), text);
}

TEST(Temporal, IsNotMeasuredOtherwise) {
  const TemporaryFolder folder;
  EXPECT_FALSE(fake_results(folder.path()).scenes.at(0).techniques.at(0).temporal);
}

}  // namespace
}  // namespace umbrameter

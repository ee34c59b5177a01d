// SPDX-License-Identifier: Apache-2.0
// Without these a sequence could stand still, jump by whole texels, or leave the results.
#include "lab/temporal.h"

#include "results/results_json.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace umbrameter {
namespace {

Scene scene_with(LightType type) {
  Scene scene = fake_scene("plate").scene;
  scene.camera.at_world = {0, 0, -10};
  scene.lights[0].type = type;
  scene.lights[0].center_world = {0, 10, -10};
  return scene;
}

TEST(Moments, MoveTheCameraByIrrationalPixels) {
  const Scene scene = scene_with(LightType::rect);
  const Camera start = scene.camera;
  const Camera moved = moment_of(scene, Motion::camera, 2, 100).camera;
  const double px_world =
      2.0 * glm::distance(start.eye_world, start.at_world) * std::tan(glm::radians(22.5)) / 100.0;
  const glm::dvec3 step = (moved.eye_world - start.eye_world) / px_world;
  EXPECT_NEAR(step.x, 2.0 * 3.618, 1e-3);
  EXPECT_NEAR(glm::length(step), 2.0 * std::hypot(3.618034, 1.414214), 1e-4);
  EXPECT_NEAR(glm::distance(moved.at_world - moved.eye_world, start.at_world - start.eye_world), 0.0, 1e-12);
}

TEST(Moments, MoveALightAsideAndTurnTheSun) {
  const Scene rect = scene_with(LightType::rect);
  const Light moved = moment_of(rect, Motion::light, 3, 100).light;
  EXPECT_NEAR(glm::distance(moved.center_world, rect.light().center_world), 3 * 0.00618034 * 10.0, 1e-6);
  const Light sun = moment_of(scene_with(LightType::sun), Motion::light, 3, 100).light;
  EXPECT_NEAR(std::acos(glm::dot(sun.direction_world, glm::dvec3(0, -1, 0))), 3 * 0.00618034, 1e-6);
  EXPECT_NEAR(glm::dot(sun.direction_world, sun.tangent_world), 0.0, 1e-12);
}

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

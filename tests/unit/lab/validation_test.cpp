// SPDX-License-Identifier: Apache-2.0
// Without these tests a failing run could take the others down, a wrong truth could be scored, or a number
// could be attached to the wrong technique.

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "core/image_io.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

class Validation : public testing::Test {
 protected:
  Results run(FakeRenderer& reference, FakeRenderer& realtime, const std::vector<TechniqueRun>& techniques) {
    const std::vector<SceneJob> scenes{fake_scene("plate"), fake_scene("assets/bunny")};
    return run_validation(scenes, fake_plan(techniques), {reference, realtime}, folder_.path(), progress_);
  }

  TemporaryFolder folder_;
  SilentProgress progress_;
};

TEST_F(Validation, MeasuresAKnownError) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  const Results results = run(reference, realtime, {fake_technique("exact"), fake_technique("off")});
  ASSERT_EQ(results.scenes.size(), 2u);
  const SceneResult& scene = results.scenes[0];
  ASSERT_TRUE(scene.parity && scene.parity->passes);
  ASSERT_TRUE(scene.techniques[0].error && scene.techniques[1].error);
  EXPECT_EQ(scene.techniques[0].error->rmse->value, 0.0);
  // 39 columns are scored, 19 of them are 0.1 too bright: mean 0.1 * 19/39, mse 0.01 * 19/39.
  const VisibilityError& off = *scene.techniques[1].error;
  EXPECT_EQ(off.scored_pixels, 39u * kFakeHeight_px);
  EXPECT_NEAR(*off.bias, 0.1 * 19 / 39, 1e-6);
  EXPECT_NEAR(off.mse->value, 0.01 * 19 / 39, 1e-6);
  EXPECT_NEAR(*off.under_shadowing, 0.1 * 19 / 39, 1e-6);
  EXPECT_EQ(*off.over_shadowing, 0.0);
}

TEST_F(Validation, RecordsAFailingRunAndGoesOn) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  const Results results = run(reference, realtime, {fake_technique("broken"), fake_technique("exact")});
  const SceneResult& scene = results.scenes[0];
  ASSERT_TRUE(scene.techniques[0].failure);
  EXPECT_EQ(scene.techniques[0].failure->kind, ErrorKind::input);
  EXPECT_EQ(scene.techniques[0].failure->message, "broken/resolve.frag:7:3: does not compile");
  EXPECT_FALSE(scene.techniques[0].error);
  EXPECT_TRUE(scene.techniques[1].error);
  EXPECT_EQ(all_failures(results).size(), 2u);  // once a scene
}

TEST_F(Validation, RendersNoReferenceWhenEveryTechniqueFailed) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  run(reference, realtime, {fake_technique("broken")});
  EXPECT_TRUE(reference.requests.empty());
}

TEST_F(Validation, RendersTheReferenceOnceAScene) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  run(reference, realtime, {fake_technique("exact"), fake_technique("off")});
  EXPECT_EQ(reference.requests.size(), 2u);
}

TEST_F(Validation, SkipsALightThatATechniqueDoesNotSupportAndSaysWhy) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  const Results results =
      run(reference, realtime, {fake_technique("far", {LightType::sun}), fake_technique("exact")});
  ASSERT_EQ(results.skipped.size(), 2u);
  EXPECT_EQ(results.skipped[0].scene, "plate");
  EXPECT_EQ(results.skipped[0].technique, "far");
  EXPECT_EQ(results.skipped[0].reason, "does not support rect lights");
  EXPECT_EQ(results.scenes[0].techniques.size(), 1u);
}

TEST_F(Validation, FailingParityVoidsTheNumbers) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime([](const RenderRequest&) {
    Image image = technique_image(0.0f);
    for (float& y_world : image.plane("position.y")) y_world += 1.0f;
    for (float& primitive : image.plane("primitive_id")) primitive += 5.0f;
    return frame_of(std::move(image));
  });
  const Results results = run(reference, realtime, {fake_technique("exact")});
  ASSERT_TRUE(results.scenes[0].parity);
  EXPECT_FALSE(results.scenes[0].parity->passes);
  EXPECT_FALSE(results.scenes[0].techniques[0].error);
  EXPECT_FALSE(parity_passes(results));
}

TEST_F(Validation, AFailingReferenceIsRecorded) {
  FakeRenderer reference([](const RenderRequest&) -> Frame { throw std::runtime_error("out of luck"); });
  FakeRenderer realtime = fake_realtime();
  const Results results = run(reference, realtime, {fake_technique("exact")});
  ASSERT_TRUE(results.scenes[1].failure);
  EXPECT_EQ(results.scenes[1].failure->kind, ErrorKind::internal);
  EXPECT_EQ(results.scenes[1].failure->message, "out of luck");
}

TEST_F(Validation, CancellationEndsEverything) {
  FakeRenderer reference([](const RenderRequest&) -> Frame { throw Error(ErrorKind::cancelled, "stopped"); });
  FakeRenderer realtime = fake_realtime();
  EXPECT_THROW(run(reference, realtime, {fake_technique("exact")}), Error);
}

TEST_F(Validation, ImagesSayWhatTheyAre) {
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime = fake_realtime();
  const Results results = run(reference, realtime, {fake_technique("off")});
  const SceneResult& scene = results.scenes[1];
  EXPECT_EQ(scene.reference->image_file, "images/assets-bunny/reference.exr");
  const Image image = read_image(folder_.path() / scene.techniques[0].image_file);
  EXPECT_EQ(image.metadata.at("scene_hash"), "0123456789abcdef");
  EXPECT_EQ(image.metadata.at("technique"), "off");
  EXPECT_EQ(image.metadata.at("parameters"), "fit=visible radius_texels=2.5 taps=16");
  EXPECT_EQ(image.metadata.at("seed"), "7");
  EXPECT_EQ(image.metadata.at("eye_world"), "0 10 0");
  EXPECT_FLOAT_EQ(image.plane("visibility")[1], 0.6f);
  for (const std::string& file : {scene.reference->picture_file, scene.parity->picture_file,
                                  scene.techniques[0].picture_file, scene.techniques[0].error_picture_file}) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / file)) << file;
  }
}

TEST_F(Validation, TimesAsManyFramesAsTheBudgetAllows) {
  FakeRenderer reference = fake_reference();
  FakeRenderer fast = fake_realtime(1.0);
  EXPECT_EQ(run(reference, fast, {fake_technique("exact")}).scenes[0].techniques[0].pass_times[0].frames, 5);
  FakeRenderer middling = fake_realtime(1000.0);  // the budget is three seconds
  EXPECT_EQ(run(reference, middling, {fake_technique("exact")}).scenes[0].techniques[0].pass_times[0].frames,
            3);
  FakeRenderer slow = fake_realtime(2000.0);
  EXPECT_EQ(run(reference, slow, {fake_technique("exact")}).scenes[0].techniques[0].pass_times[0].frames, 1);
}

}  // namespace
}  // namespace umbrameter

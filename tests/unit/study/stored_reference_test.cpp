// SPDX-License-Identifier: Apache-2.0
// Without these a bench or a tuner could render a truth that is known, or take another camera's, another size's or a damaged
// one for its own.

#include "lab/stored_reference.h"

#include "core/files.h"
#include "results/bench/bench_json.h"
#include "results/tune/tune_json.h"
#include "scenes/scene_hash.h"
#include "study/grid/sweep.h"
#include "study/tune/tune.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace umbrameter {
namespace {

using testing::HasSubstr;

class StoredTruths : public testing::Test {
 protected:
  StoredTruths() { create_folder(scratch()); }

  std::filesystem::path scratch() const { return folder_.path() / "scratch"; }
  std::filesystem::path out() const { return folder_.path() / "out"; }
  Makers makers() const { return {maker_, "device", "shaders"}; }

  /// As another process would.
  template <class Work>
  auto with_cache(const Work& work) {
    LazyStore store(out());
    StoredReference reference(tracer_, picture_, store, makers(), reuse_, scratch());
    auto result = work(reference);
    reused_ = reference.take_reused();
    warnings_ = store.take_warnings();
    return result;
  }
  Frame render() {
    return with_cache(
        [&](Renderer& reference) { return reference.render(job_.scene, request_of(picture_), progress_); });
  }
  /// Truths rendered since it was last asked.
  size_t rendered() {
    const size_t count = tracer_.requests.size();
    tracer_.requests.clear();
    return count;
  }

  TemporaryFolder folder_;
  SilentProgress progress_;
  PictureQuality picture_{kFakeWidth_px, kFakeHeight_px, 64, {}, 7};
  std::string maker_ = "tracer";
  bool reuse_ = true;
  SceneJob job_ = fake_scene("plate");
  FakeRenderer tracer_{[](const RenderRequest&) {
    Frame frame = frame_of(shadowed_reference_image());
    frame.image.planes["half_a"][50] = 0.1f;  // no short decimal
    frame.warnings = {"a light inside a box"};
    return frame;
  }};
  ReusedTruths reused_;
  std::vector<std::string> warnings_;
};

TEST_F(StoredTruths, AreRenderedOnceAndComeBackWhole) {
  const Frame first = render();
  EXPECT_EQ(rendered(), 1u);
  EXPECT_EQ(reused_.count, 0u);
  const Frame second = render();
  EXPECT_EQ(rendered(), 0u);
  EXPECT_EQ(reused_.count, 1u);
  EXPECT_EQ(reused_.saved_s, 0.25);  // of a fake frame
  EXPECT_EQ(second.image.planes, first.image.planes);
  EXPECT_EQ(second.device, first.device);
  EXPECT_EQ(second.warnings, first.warnings);
  EXPECT_EQ(second.image.metadata.at("scene_hash"), hash_scene(job_.scene));
}

TEST_F(StoredTruths, AreOfOnePictureOnly) {
  render();
  rendered();
  const auto expect_another = [&](const char* what) {
    render();
    EXPECT_EQ(rendered(), 1u) << what;
    render();
    EXPECT_EQ(rendered(), 0u) << what;
  };
  job_.scene.camera.eye_world.x = 1.0;  // its hash stays as it was
  expect_another("camera");
  job_.scene.lights[0].radius_world = 2.0;
  expect_another("light");
  job_.scene.lights.push_back(job_.scene.lights[0]);
  job_.scene.active_light = 1;
  expect_another("active light");
  picture_.width_px *= 2;
  expect_another("width");
  picture_.height_px *= 2;
  expect_another("height");
  picture_.samples_per_pixel = 32;
  expect_another("samples");
  picture_.target_se = 0.01;
  expect_another("target");
  picture_.seed = 8;
  expect_another("seed");
  maker_ = "another tracer";
  expect_another("maker");
}

TEST_F(StoredTruths, ADamagedOneIsMadeAgain) {
  render();
  for (const auto& file : std::filesystem::recursive_directory_iterator(out() / "objects")) {
    if (file.is_regular_file()) std::ofstream(file.path(), std::ios::app) << "x";
  }
  rendered();
  render();
  EXPECT_EQ(rendered(), 1u);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_THAT(warnings_[0], HasSubstr("its image was altered; it is made again"));
  render();
  EXPECT_EQ(rendered(), 0u);
}

TEST_F(StoredTruths, WithoutReuseAllAreRenderedAndKept) {
  reuse_ = false;
  render();
  render();
  EXPECT_EQ(rendered(), 2u);
  reuse_ = true;
  render();
  EXPECT_EQ(rendered(), 0u);
}

TEST_F(StoredTruths, AFailedOneLeavesNothingBehind) {
  tracer_ = FakeRenderer([](const RenderRequest&) -> Frame { fail_input("no light"); });
  EXPECT_THROW(render(), Error);
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(StoredTruths, AreSharedWithSweeps) {
  job_.scene.hash = hash_scene(job_.scene);
  SweepPlan plan;
  plan.runs.push_back({fake_technique("off"), 7});
  plan.picture = picture_;
  plan.makers = makers();
  const std::vector<StudyScene> scenes{{"plate", job_.scene}};
  FakeRenderer realtime = fake_realtime();
  const auto sweep = [&] {
    Store store(out(), Database::Mode::write);
    const auto steps = plan_sweep(plan, scenes, &store);
    return run_sweep(plan, scenes, steps, {tracer_, realtime}, store, scratch(), progress_);
  };
  EXPECT_EQ(sweep().references_rendered, 1u);
  render();
  EXPECT_EQ(rendered(), 1u);
  picture_.seed = plan.picture.seed = 8;
  render();
  EXPECT_EQ(sweep().references_rendered, 0u);
  EXPECT_EQ(rendered(), 1u);
}

TEST_F(StoredTruths, ABenchHasTheSameNumbersFromThem) {
  BenchPlan plan;
  plan.picture = picture_;
  for (const char* id : {"exact", "off"}) plan.runs.push_back({fake_technique(id), 1});
  plan.timing = {.wanted_frames = 7, .budget_s = 1.0};
  const std::vector<StudyScene> scenes{{"plate", job_.scene}};
  const auto bench = [&] {
    return with_cache([&](Renderer& reference) {
      FakeRenderer realtime = fake_realtime();
      return to_json_text(run_bench(scenes, plan, {reference, realtime}, progress_), {});
    });
  };
  const std::string first = bench();
  EXPECT_THAT(first, HasSubstr("\"rmse\": {"));
  EXPECT_EQ(rendered(), 1u);
  EXPECT_EQ(bench(), first);
  EXPECT_EQ(rendered(), 0u);
}

TEST_F(StoredTruths, ATunerHasTheSameNumbersFromThem) {
  job_.scene.camera.up_world = {0, 0, 1};
  Parameter bias;
  bias.name = "bias_texels";
  bias.default_value = 4.0;
  bias.max = 32.0;
  bias.unit = "texels";
  TunePlan plan;
  plan.technique = fake_technique("fake");
  plan.parameters = {bias};
  plan.technique.parameters = default_values(plan.parameters);
  plan.evaluations = 12;
  plan.seed = picture_.seed;
  FakeRenderer realtime([](const RenderRequest& request) {
    const double value =
        request.technique.empty() ? 0.0 : std::get<double>(request.parameters.at("bias_texels"));
    Frame frame = frame_of(technique_image(static_cast<float>(0.01 + 0.001 * value)));
    frame.image.add_plane("texel_world", 0.25f);
    frame.parameters = request.parameters;
    return frame;
  });
  std::vector<SceneJob> jobs{job_};
  const auto tune = [&](Renderer& reference) {
    plan.full = {kFakeWidth_px, kFakeHeight_px, &reference};
    plan.coarse = Fidelity{kFakeWidth_px / 2, kFakeHeight_px / 2, &reference};
    TuneResult result = run_tune(jobs, plan, realtime, progress_);
    result.wall_time_s = 0.0;
    return to_json_text(result);
  };
  const std::string without = tune(tracer_);
  const size_t wanted = rendered();
  EXPECT_GE(wanted, 10u);  // five cameras at both sizes
  EXPECT_EQ(with_cache(tune), without);
  EXPECT_EQ(rendered() + reused_.count, wanted);
  EXPECT_EQ(with_cache(tune), without);
  EXPECT_EQ(rendered(), 0u);
  EXPECT_EQ(reused_.count, wanted);
}

}  // namespace
}  // namespace umbrameter

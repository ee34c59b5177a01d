// SPDX-License-Identifier: Apache-2.0
// Without these a validation could render what it knows, take another setting's result for its own, remember a failure of
// the machine, or score twins differently.

#include "lab/validation_cache.h"
#include "core/error.h"
#include "results/json/results_json.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::HasSubstr;

class ValidationCaching : public testing::Test {
 protected:
  Results validate(const ValidationPlan& plan, bool reuse = true, const std::string& device = "device 1") {
    LazyStore store(folder_.path() / "out");
    ValidationCache memory(store, {"tracer", device, "shaders"}, reuse);
    const std::vector<SceneSource> sources{source_of(job_)};
    return run_validation(sources, plan, {reference_, realtime_}, folder_.path() / "out", progress_, {},
                          &memory);
  }

  size_t rendered() {
    const size_t count = reference_.requests.size() + realtime_.requests.size();
    reference_.requests.clear();
    realtime_.requests.clear();
    return count;
  }

  static TechniqueRun technique(const std::string& id) {
    TechniqueRun run = fake_technique(id);
    run.hash = "hash of " + id;
    return run;
  }

  TemporaryFolder folder_;
  SilentProgress progress_;
  FakeRenderer reference_ = fake_reference();
  FakeRenderer realtime_ = fake_realtime();
  const SceneJob job_ = fake_scene("plate");
};

TEST_F(ValidationCaching, TheSameQuestionRendersNothingAndHasTheSameAnswer) {
  const ValidationPlan plan = fake_plan({technique("exact"), technique("off")});
  const Results first = validate(plan);
  EXPECT_EQ(rendered(), 4u);  // surfaces, two techniques, the truth
  EXPECT_EQ(first.work.rendered, 2u);
  const Results second = validate(plan);
  EXPECT_EQ(rendered(), 0u);
  EXPECT_EQ(second.work.reused, 2u);
  EXPECT_EQ(second.work.references_reused, 1u);
  EXPECT_EQ(to_json_text(second), to_json_text(first));
  EXPECT_TRUE(
      std::filesystem::exists(folder_.path() / "out" / second.scenes[0].techniques[1].fault_picture_file));
}

/// A run whose bias can be taken away, as a manifest declares it.
TechniqueRun biased(const std::string& id) {
  Parameter bias;
  bias.name = "bias_texels";
  bias.group = "bias";
  bias.unit = "texels";
  bias.default_value = 1.0;
  bias.max = 32.0;
  TechniqueRun run = fake_technique(id);
  run.hash = "hash of " + id;
  run.declared = {bias};
  run.parameters = {{"bias_texels", 1.0}};
  return run;
}

TEST_F(ValidationCaching, CausesAreFoundOnceAndKept) {
  ValidationPlan plan = fake_plan({biased("off"), technique("exact")});
  validate(plan);
  rendered();
  plan.causes = CausesWanted::worst;
  const Results first = validate(plan);
  EXPECT_EQ(rendered(), 3u);  // no bias, a tenth of it, ten times the bias
  const auto& causes = first.scenes[0].techniques[0].fault_causes;
  ASSERT_TRUE(causes && !causes->skipped);
  ASSERT_EQ(causes->outcomes.size(), 3u);
  EXPECT_EQ(causes->outcomes[0].removed[0], 0.0);  // "off" is wrong whatever its bias
  EXPECT_FALSE(first.scenes[0].techniques[1].fault_causes);
  const Results second = validate(plan);
  EXPECT_EQ(rendered(), 0u);
  EXPECT_EQ(to_json_text(second), to_json_text(first));
  plan.causes = CausesWanted::none;
  EXPECT_FALSE(validate(plan).scenes[0].techniques[0].fault_causes);
  EXPECT_EQ(rendered(), 0u);
}

/// biased() with a filter and a map: its causes take 3 pictures of other biases, 8 of other filters, 16 of two larger maps and
/// 16 of the light's points.
TechniqueRun with_many_causes(const std::string& id) {
  TechniqueRun run = biased(id);
  const auto add = [&](const std::string& name, const std::string& group, double value, double max) {
    Parameter parameter = run.declared.front();
    parameter.name = name;
    parameter.group = group;
    parameter.max = max;
    if (group == "shadow_map") parameter.scale = ParameterScale::pow2;
    run.parameters[name] = value;
    run.declared.push_back(parameter);
  };
  add("radius_texels", "filter", 2.0, 32.0);
  add("map_size", "shadow_map", 256.0, 4096.0);
  return run;
}

TEST_F(ValidationCaching, CausesThatCostMoreThanTheSceneAreLeftOutUnlessAskedFor) {
  ValidationPlan plan = fake_plan({with_many_causes("off")});
  plan.causes = CausesWanted::automatic;
  const Results skipped = validate(plan);
  ASSERT_TRUE(skipped.scenes[0].techniques[0].fault_causes);
  EXPECT_THAT(skipped.scenes[0].techniques[0].fault_causes->skipped.value_or(""),
              testing::AllOf(HasSubstr("about 43 pictures"), HasSubstr("--causes worst")));
  rendered();
  validate(plan);
  EXPECT_EQ(rendered(), 0u);  // the decision is kept, too
  plan.causes = CausesWanted::worst;
  EXPECT_FALSE(validate(plan).scenes[0].techniques[0].fault_causes->skipped);
  EXPECT_EQ(rendered(), 25u);  // each once, and the light's points
}

TEST_F(ValidationCaching, WhetherCausesAreWorthTheirCostIsNoMatterOfTime) {
  const auto is_tried = [&](int timed_frames, double frame_ms) {
    realtime_ = fake_realtime(frame_ms);
    ValidationPlan plan = fake_plan({with_many_causes("off")});
    plan.timed_frames = timed_frames;
    plan.causes = CausesWanted::automatic;
    return !validate(plan).scenes[0].techniques[0].fault_causes->skipped;
  };
  EXPECT_FALSE(is_tried(5, 0.001));
  EXPECT_FALSE(is_tried(6, 1000.0));
  EXPECT_TRUE(is_tried(50, 0.001));
  EXPECT_TRUE(is_tried(51, 1000.0));
}

TEST_F(ValidationCaching, ASkipOfOneSceneIsNoSkipOfALargerOne) {
  ValidationPlan plan = fake_plan({with_many_causes("off")});
  plan.causes = CausesWanted::automatic;
  EXPECT_TRUE(validate(plan).scenes[0].techniques[0].fault_causes->skipped);
  for (int k = 0; k < 5; ++k) plan.techniques.push_back(technique("exact " + std::to_string(k)));
  EXPECT_FALSE(validate(plan).scenes[0].techniques[0].fault_causes->skipped);
}

TEST_F(ValidationCaching, CausesAreOfTheThreeWorstUnlessOfAll) {
  std::vector<TechniqueRun> runs;
  for (int k = 0; k < 5; ++k) {
    runs.push_back(biased("off"));
    runs.back().label = "off " + std::to_string(k);
    runs.back().hash += std::to_string(k);
  }
  ValidationPlan plan = fake_plan(runs);
  const auto with_causes = [&](CausesWanted wanted) {
    plan.causes = wanted;
    const Results results = validate(plan);
    return std::ranges::count_if(results.scenes[0].techniques,
                                 [](const TechniqueResult& run) { return run.fault_causes.has_value(); });
  };
  EXPECT_EQ(with_causes(CausesWanted::worst), 3);
  EXPECT_EQ(with_causes(CausesWanted::all), 5);
  EXPECT_EQ(with_causes(CausesWanted::none), 0);
}

TEST_F(ValidationCaching, WhateverChangesANumberIsAnotherQuestion) {
  const ValidationPlan plan = fake_plan({technique("off")});
  validate(plan);
  rendered();
  ValidationPlan other = plan;
  other.limit_rmse = 0.01;
  EXPECT_EQ(validate(other).work.rendered, 1u);
  other = plan;
  other.timed_frames = 3;
  EXPECT_EQ(validate(other).work.rendered, 1u);
  other = plan;
  other.techniques[0].parameters["taps"] = int64_t{32};
  EXPECT_EQ(validate(other).work.rendered, 1u);
  other = plan;
  other.picture.seed = 8;
  EXPECT_EQ(validate(other).work.references_rendered, 1u);
  EXPECT_EQ(validate(plan, true, "device 2").work.rendered, 1u);
  EXPECT_EQ(validate(plan, false).work.rendered, 1u);
  EXPECT_EQ(validate(plan).work.rendered, 0u);
}

TEST_F(ValidationCaching, OnlyFailuresOfTheInputAreRemembered) {
  const ValidationPlan plan = fake_plan({technique("broken"), technique("exact")});
  validate(plan);
  EXPECT_EQ(validate(plan).work.reused, 2u);
  EXPECT_EQ(all_failures(validate(plan)).size(), 1u);

  realtime_ = FakeRenderer([](const RenderRequest& request) {
    if (request.technique == "tired") fail_environment("the GPU is gone");
    return frame_of(technique_image(0.0f));
  });
  const ValidationPlan tired = fake_plan({technique("tired"), technique("exact")});
  EXPECT_EQ(validate(tired).scenes[0].techniques[0].failure->kind, ErrorKind::environment);
  realtime_ = fake_realtime();
  const Results again = validate(tired);
  EXPECT_FALSE(again.scenes[0].techniques[0].failure);
  EXPECT_EQ(again.work.rendered, 1u);
}

TEST_F(ValidationCaching, AVerdictIsOfTheBaselineThatIsAskedFor) {
  ValidationPlan plan = fake_plan({technique("exact"), technique("off")});
  validate(plan);
  plan.baseline = "off";
  rendered();
  const Results other = validate(plan);
  EXPECT_EQ(rendered(), 0u);
  EXPECT_FALSE(other.scenes[0].techniques[1].judgement.verdict);
  ASSERT_TRUE(other.scenes[0].techniques[0].judgement.verdict);
  EXPECT_EQ(other.scenes[0].techniques[0].judgement.verdict->baseline, "off");
}

TEST_F(ValidationCaching, EqualPicturesAreScoredOnce) {
  ValidationPlan plan = fake_plan({technique("exact"), technique("same")});
  const Results twins = validate(plan);
  ASSERT_EQ(twins.scenes[0].techniques[1].left_out.size(), 1u);
  EXPECT_THAT(twins.scenes[0].techniques[1].left_out[0], HasSubstr("that of 'exact'"));
  plan.skip = false;
  const Results all = validate(plan);
  EXPECT_EQ(all.work.rendered, 2u);
  EXPECT_TRUE(all.scenes[0].techniques[1].left_out.empty());
  EXPECT_EQ(all.scenes[0].techniques[1].error->rmse->value, twins.scenes[0].techniques[1].error->rmse->value);
}

TEST_F(ValidationCaching, ASceneThatTheLightDoesNotReachIsSkipped) {
  const auto dark = [](Image image) {
    for (float& e : image.plane("unshadowed_irradiance")) e = 0.0f;
    return frame_of(std::move(image));
  };
  realtime_ = FakeRenderer([&](const RenderRequest&) { return dark(technique_image(0.0f)); });
  reference_ = FakeRenderer([&](const RenderRequest&) { return dark(reference_image()); });
  ValidationPlan plan = fake_plan({technique("exact")});
  const Results skipped = validate(plan);
  EXPECT_EQ(rendered(), 1u);  // the surfaces
  EXPECT_TRUE(skipped.scenes[0].techniques.empty());
  ASSERT_EQ(skipped.skipped.size(), 1u);
  EXPECT_EQ(skipped.skipped[0].reason, "the light reaches nothing in the picture");
  EXPECT_EQ(validate(plan).skipped.size(), 1u);
  EXPECT_EQ(rendered(), 0u);
  plan.skip = false;
  const Results all = validate(plan);
  ASSERT_EQ(all.scenes[0].techniques.size(), 1u);
  EXPECT_EQ(all.scenes[0].techniques[0].error->scored_pixels, 0u);
}

}  // namespace
}  // namespace umbrameter

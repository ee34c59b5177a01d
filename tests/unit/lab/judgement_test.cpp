// SPDX-License-Identifier: Apache-2.0
// Without these a verdict could name the wrong baseline, get lost on its way to the user, or be computed unasked.

#include "metrics/judgement.h"

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "core/error.h"
#include "lab/score.h"
#include "results/json/results_json.h"
#include "results/judgement_format.h"
#include "results/metric_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class Judged : public testing::Test {
 protected:
  SceneResult scene(const ValidationPlan& plan) {
    const std::vector<SceneJob> scenes{fake_scene("plate")};
    FakeRenderer reference = fake_reference();
    FakeRenderer realtime = fake_realtime();
    return run_validation(scenes, plan, {reference, realtime}, folder_.path(), progress_).scenes.at(0);
  }
  static ValidationPlan plan() {
    TechniqueRun again = fake_technique("off");
    again.label = "off again";
    return fake_plan({fake_technique("broken"), fake_technique("off"), fake_technique("exact"), again});
  }

  TemporaryFolder folder_;
  SilentProgress progress_;
};

TEST_F(Judged, ComparesWithTheFirstTechniqueThatHasAResult) {
  const SceneResult result = scene(plan());
  EXPECT_FALSE(result.techniques[0].judgement.verdict);  // broken
  EXPECT_FALSE(result.techniques[1].judgement.verdict);  // the baseline itself
  const RunVerdict& exact = *result.techniques[2].judgement.verdict;
  EXPECT_EQ(exact.baseline, "off");
  EXPECT_NEAR(exact.mse_difference.value, -0.01 * 19 / 39, 1e-6);
  EXPECT_EQ(result.techniques[3].judgement.verdict->outcome, Comparison::same);
}

TEST_F(Judged, ComparesWithHardWhereverItStands) {
  ValidationPlan with_hard = plan();
  with_hard.techniques[2].label = "hard";
  const SceneResult result = scene(with_hard);
  EXPECT_EQ(result.techniques[1].judgement.verdict->baseline, "hard");
  EXPECT_FALSE(result.techniques[2].judgement.verdict);
}

TEST_F(Judged, ComparesWithTheBaselineThatWasAskedFor) {
  ValidationPlan asked = plan();
  asked.baseline = "exact";
  const SceneResult result = scene(asked);
  EXPECT_EQ(result.techniques[1].judgement.verdict->baseline, "exact");
  EXPECT_NEAR(result.techniques[1].judgement.verdict->mse_difference.value, 0.01 * 19 / 39, 1e-6);
  asked.baseline = "broken";
  EXPECT_FALSE(scene(asked).techniques[1].judgement.verdict);
}

TEST_F(Judged, FindsEveryWrongPixelOfAnExactReference) {
  const SceneResult result = scene(plan());
  const SignificanceNumbers& off = *result.techniques[1].judgement.significance;
  EXPECT_EQ(off.tested, 39u * kFakeHeight_px);
  EXPECT_EQ(off.too_bright, 19u * kFakeHeight_px);
  EXPECT_EQ(off.too_dark, 0u);
  EXPECT_EQ(result.techniques[2].judgement.significance->too_bright, 0u);
}

TEST_F(Judged, ComputesOnlyWhatWasAskedFor) {
  ValidationPlan asked = plan();
  asked.metrics = choose_metrics("error");
  const TechniqueResult off = scene(asked).techniques[1];
  EXPECT_TRUE(off.error);
  EXPECT_FALSE(off.judgement.significance || off.judgement.verdict || off.judgement.limit || off.diagnosis);
  EXPECT_EQ(off.fault_picture_file, "");
  EXPECT_TRUE(off.warnings.empty());
  asked.metrics = choose_metrics("verdict,diagnosis");
  const TechniqueResult exact = scene(asked).techniques[2];
  EXPECT_TRUE(exact.judgement.verdict && exact.diagnosis);
  EXPECT_FALSE(exact.judgement.significance);
}

TEST(ChooseMetrics, RejectsAnUnknownNameAndTakesNothingForAll) {
  EXPECT_THAT(
      [] { choose_metrics("error,significanse"); },
      ThrowsMessage<Error>(HasSubstr("unknown metric 'significanse' (did you mean 'significance'?)")));
  EXPECT_THROW(choose_metrics("error,,verdict"), Error);
  const MetricChoice all = choose_metrics("");
  EXPECT_TRUE(all.significance && all.verdict && all.diagnosis);
}

TEST(Limit, IsFailedOnlyForCertain) {
  Image reference = reference_image();
  const auto judged = [&](double limit) {
    return score_image(technique_image(0.1f), reference, {0, 10, 0}, {choose_metrics("error"), limit})
        .judgement.limit.value();
  };
  // Two tiles of a scene tell little: the interval reaches far beyond the RMSE of .07.
  EXPECT_EQ(judged(0.9).outcome, LimitOutcome::pass);
  EXPECT_EQ(judged(0.07).outcome, LimitOutcome::cannot_tell);
  EXPECT_FALSE(judged(0.07).more_samples);  // an exact reference gains nothing by more
  EXPECT_EQ(judged(0.07).limit_rmse, 0.07);
}

TEST(JudgementJson, SurvivesTheFile) {
  Results results;
  results.scenes.resize(1);
  TechniqueResult run;
  run.judgement.significance = SignificanceNumbers{100, 3, 4, 2.5, 9, 0.27, std::nullopt};
  run.judgement.verdict = RunVerdict{"hard", Comparison::worse, {0.1, 0.05, 0.15}, std::nullopt};
  run.judgement.limit = LimitNumbers{0.02, LimitOutcome::cannot_tell, 512.0};
  results.scenes[0].techniques = {run, TechniqueResult{}};
  const std::string text = to_json_text(results);
  const Results back = parse_results(text, "results.json");
  EXPECT_EQ(to_json_text(back), text);
  const Judgement& judgement = back.scenes[0].techniques[0].judgement;
  EXPECT_EQ(judgement.significance->too_bright, 4u);
  EXPECT_EQ(judgement.significance->expected_exceeding, 0.27);
  EXPECT_EQ(judgement.verdict->outcome, Comparison::worse);
  EXPECT_EQ(judgement.verdict->mse_difference.high, 0.15);
  EXPECT_EQ(judgement.limit->more_samples, 512.0);
  EXPECT_FALSE(back.scenes[0].techniques[1].judgement.limit);
}

TEST(JudgementLines, SayWhatWouldDecide) {
  Judgement judgement;
  judgement.significance = SignificanceNumbers{100, 3, 4, 2.5, 9, 0.27, 17.0};
  judgement.verdict = RunVerdict{"hard", Comparison::cannot_tell, {-0.001, -0.003, 0.001}, 2048.4};
  judgement.limit = LimitNumbers{0.02, LimitOutcome::cannot_tell, std::nullopt};
  const TermLines lines = judgement_lines(judgement);
  EXPECT_EQ(lines[0].second,
            "7 of 100 stand out from the noise, from 2.5 sigmas on: 3 too dark, 4 too bright");
  EXPECT_EQ(lines[1].second, "9 pixels; noise alone would give 0");
  EXPECT_EQ(lines[2].second,
            "against hard: cannot tell, mean squared error -1.00e-03 [-3.00e-03, +1.00e-03]; about 2048 more "
            "samples per pixel would decide");
  EXPECT_EQ(lines[3].second, "RMSE 0.02: cannot tell; more samples would not decide, other views may");
  EXPECT_TRUE(judgement_lines({}).empty());
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a tuner could prefer what it cannot measure, end up worse than what people set by hand, or leave out what
// is asked most.

#include "tests/unit/study/tune_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace umbrameter {
namespace {

using testing::HasSubstr;

TEST_F(Tune, FindsTheBestBiasAndComparesItAtTheSameCost) {
  const TuneResult result = run();
  EXPECT_NEAR(bias_of(result.best.values), kBestBias, 0.02);
  EXPECT_EQ(result.best.values.at("taps"), ParameterValue(int64_t{16}));
  EXPECT_EQ(result.tuned, std::vector<std::string>{"bias_texels"});
  EXPECT_LE(result.evaluations, 40u);
  ASSERT_EQ(result.others.size(), 3u);
  EXPECT_EQ(result.others[0].name, "default, medium");
  EXPECT_EQ(result.others[0].ratio, 1.0);
  EXPECT_EQ(result.others[1].name, "engine");
  EXPECT_EQ(result.others[1].values.at("taps"), ParameterValue(int64_t{16}));
  EXPECT_EQ(result.others[2].name, "engine (own cost)");
  EXPECT_FALSE(result.others[2].same_cost);
  EXPECT_LT(result.best.ratio, result.others[1].ratio);
  EXPECT_LT(result.others[2].ratio, result.best.ratio);  // it pays for it
  // Half of the pixels are wrong by 0.02 at best: rmse 0.02 / sqrt(2), to a pixel column.
  EXPECT_NEAR(result.best.scores.front().objective->value, 0.02 / std::sqrt(2.0), 0.001);
}

TEST_F(Tune, ANamedCostIsTunedToo) {
  plan.tuned = {"bias_texels", "taps"};
  EXPECT_GT(std::get<int64_t>(run().best.values.at("taps")), 32);
}

TEST_F(Tune, SaysHowSureItIsThatTheTunedValuesAreBetter) {
  const TuneResult result = run();
  for (const Candidate& other : result.others) {
    ASSERT_TRUE(other.gain && other.held_out_gain) << other.name;
    // The truth is without noise and all cameras see the same picture: what is left is the difference of the ratios.
    EXPECT_NEAR(other.held_out_gain->value, *other.held_out_ratio - *result.best.held_out_ratio, 1e-6);
    EXPECT_LE(other.gain->low, other.gain->value);
    EXPECT_GE(other.gain->high, other.gain->value);
  }
  EXPECT_GT(result.others[0].gain->low, 0.0);   // the default
  EXPECT_LT(result.others[2].gain->high, 0.0);  // with more taps
  EXPECT_FALSE(result.best.gain);
}

TEST_F(Tune, APresetItKeepsToTiesWithIt) {
  plan.presets = {{"best", {{"bias_texels", kBestBias}}}};
  const TuneResult result = run();
  ASSERT_TRUE(result.others[1].held_out_gain);
  EXPECT_EQ(result.others[1].held_out_gain->low, 0.0);
  EXPECT_EQ(result.others[1].held_out_gain->high, 0.0);
}

TEST_F(Tune, AHurriedOneStillComparesAndSaysWhatIsMissing) {
  plan.cameras = 1;
  plan.time_limit_s = 1e-9;  // the first start alone
  const TuneResult hurried = run();
  EXPECT_FALSE(hurried.is_converged);
  EXPECT_EQ(hurried.full_trials.size(), 1u);
  EXPECT_EQ(hurried.others.size(), 2u);  // not the preset with its own taps
  EXPECT_TRUE(hurried.sensitivities.empty());
  EXPECT_THAT(hurried.notes, testing::ElementsAre(HasSubstr("safe window"), HasSubstr("sensitivities"),
                                                  HasSubstr("engine (own cost)")));
  ASSERT_EQ(hurried.windows.size(), 1u);
  EXPECT_FALSE(hurried.windows[0].is_complete);
}

TEST_F(Tune, OnlyWhatWasTriedIsSaidToMakeNoDifference) {
  Parameter idle;
  idle.name = "slope";
  idle.default_value = 0.0;
  idle.max = 1.0;
  plan.parameters.push_back(idle);
  plan.technique.parameters = default_values(plan.parameters);
  plan.presets = {{"engine", {{"bias_texels", 1.5}, {"slope", 0.5}}}};
  const auto is_named = [&] {
    return std::ranges::any_of(run().notes, [](const std::string& note) {
      return note.find("'slope' need not be tuned here: 3 values") != std::string::npos;
    });
  };
  EXPECT_TRUE(is_named());
  plan.evaluations =
      6;  // two values of it were rendered, of the default and the preset, which differ in the bias, too
  for (const std::string& note : run().notes) EXPECT_THAT(note, testing::Not(HasSubstr("slope")));
}

TEST_F(Tune, WhatDoesNotActCostsNothing) {
  const TuneResult before = run();
  Parameter curve;
  curve.name = "curve_scale";
  curve.default_value = 1.0;
  curve.max = 8.0;
  curve.when = "curve == curve.squared";
  plan.parameters.push_back(curve);
  plan.technique.parameters = default_values(plan.parameters);
  plan.is_active = [](const Parameter& parameter, const ParameterValues&) {
    return parameter.name != "curve_scale";
  };
  plan.evaluations = 40 + 1;  // settle() is left one an axis
  const TuneResult result = run();
  EXPECT_EQ(result.full_trials.size(), before.full_trials.size());
  EXPECT_EQ(result.best.values.at("curve_scale"), ParameterValue(1.0));
  EXPECT_EQ(result.sensitivities.size(), 1u);
  EXPECT_THAT(result.notes,
              testing::Contains(HasSubstr("'curve_scale' was not tuned: it acts only when curve == ")));
}

TEST_F(Tune, WindowsComeFirst) {
  plan.cameras = 1;
  const TuneResult result = run();
  ASSERT_EQ(result.windows.size(), 2u);
  EXPECT_FALSE(result.windows[0].is_at_tuned);
  EXPECT_TRUE(result.windows[1].is_at_tuned);
  EXPECT_TRUE(result.windows[0].is_complete && result.windows[1].is_complete);
  std::vector<double> first;
  for (const RenderRequest& request : realtime.requests) {
    if (!request.technique.empty()) first.push_back(bias_of(request.parameters));
  }
  // The defaults, a look at the texels, and then at once the eight levels of the window.
  ASSERT_GT(first.size(), 10u);
  EXPECT_EQ(first[0], 4.0);
  EXPECT_EQ(first[1], 4.0);
  EXPECT_EQ(first[2], 0.0);
  EXPECT_EQ(first[9], 32.0);
}

TEST_F(Tune, KeepsToThePresetThatIsAsGood) {
  plan.presets = {{"best", {{"bias_texels", kBestBias}}}};
  EXPECT_EQ(bias_of(run().best.values), kBestBias);
}

/// Low errors want both a low bias and the flag; a low bias alone ruins the picture of one camera.
class RuinedFromOneSide final : public Renderer {
 public:
  Frame render(const Scene& scene, const RenderRequest& request, Progress&) override {
    if (request.technique.empty()) return frame_of(floor_image());
    const bool is_low = bias_of(request.parameters) < 2.0;
    const bool has_flag = std::get<bool>(request.parameters.at("flag"));
    const bool is_ruined =
        is_low && !has_flag && scene.camera.eye_world.x > 2.0;  // from 12 degrees on, 10 away
    const double error = is_ruined ? 0.4 : is_low ? 0.05 : 0.1;
    return frame_of(technique_image(static_cast<float>(error + (has_flag ? 0.001 : 0.0))));
  }
};

TEST_F(Tune, NeverEndsUpWorseThanByHand) {
  Parameter flag;
  flag.name = "flag";
  flag.type = ParameterType::boolean;
  flag.default_value = false;
  plan.parameters.push_back(flag);
  plan.technique.parameters = default_values(plan.parameters);
  RuinedFromOneSide renderer;
  const TuneResult result = run_tune(scenes, plan, renderer, progress);
  for (const Candidate& other : result.others) EXPECT_LE(result.best.ratio, other.ratio) << other.name;
  EXPECT_LT(result.best.ratio, 0.6);
}

TEST_F(Tune, BeginsSmallAndGoesOnAtFullSize) {
  plan.coarse = plan.full;  // the fake has one size; what counts is that both are searched
  const TuneResult result = run();
  EXPECT_GT(result.coarse_evaluations, 0u);
  EXPECT_GT(result.evaluations, result.coarse_evaluations);
  EXPECT_NEAR(bias_of(result.best.values), kBestBias, 0.02);
}

TEST_F(Tune, AGridChecksTheSearch) {
  plan.grid_steps = 21;
  const TuneResult result = run();
  ASSERT_TRUE(result.grid);
  EXPECT_EQ(result.grid->evaluations, 21u);
  EXPECT_LE(result.best.ratio, 1.02 * result.grid->best_ratio);
}

TEST_F(Tune, OneSettingForSeveralScenes) {
  scenes.push_back(fake_scene("fence"));
  scenes[1].scene.camera.up_world = {0, 0, 1};
  const TuneResult result = run();
  EXPECT_EQ(result.scenes.size(), 2u);
  EXPECT_NEAR(bias_of(result.best.values), kBestBias, 0.02);
}

TEST_F(Tune, SensitivityIsTheRiseOneStepAway) {
  const TuneResult result = run();
  ASSERT_EQ(result.sensitivities.size(), 1u);
  // A step is a twentieth of the axis: 0.05 cbrt(32) = 0.159 of the cube root, so 0.05 * 0.159 on 0.02: 40 %.
  EXPECT_NEAR(*result.sensitivities[0].rise_above, 0.40, 0.03);
  EXPECT_NEAR(*result.sensitivities[0].rise_below, 0.40, 0.03);
}

TEST_F(Tune, SaysWhatAnObjectiveLacks) {
  plan.objective = {"penumbra"};  // the fakes' truth has no edge
  try {
    run();
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("plate has nothing that objective 'penumbra' measures"));
  }
}

}  // namespace
}  // namespace umbrameter

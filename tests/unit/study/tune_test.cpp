// SPDX-License-Identifier: Apache-2.0
// Without these, a tuner could prefer what it cannot measure, promise a window that is not there, learn from the cameras it
// is judged on, or write down other numbers than it measured.

#include "study/tune/tune.h"

#include "core/error.h"
#include "study/tune/draw_and_score.h"
#include "study/tune/lengths.h"
#include "study/tune/tune_files.h"
#include "study/tune/tune_json.h"
#include "tests/unit/study/fakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

constexpr double kBestBias = 0.7;

Parameter bias_parameter() {
  Parameter parameter;
  parameter.name = "bias_texels";
  parameter.default_value = 4.0;
  parameter.max = 32.0;
  parameter.unit = "texels";
  parameter.group = "bias";
  return parameter;
}

Parameter taps_parameter() {
  Parameter parameter;
  parameter.name = "taps";
  parameter.type = ParameterType::integer;
  parameter.default_value = int64_t{16};
  parameter.min = 1;
  parameter.max = 64;
  parameter.unit = "taps";
  return parameter;
}

double bias_of(const ParameterValues& values) {
  return std::get<double>(values.at("bias_texels"));
}

/// Error of a bias: 0.02 at best, more to both sides, and half of it with 64 taps. Fails from 20 texels on.
Frame render(const RenderRequest& request) {
  if (request.technique.empty()) return frame_of(floor_image());
  const double bias = bias_of(request.parameters);
  if (bias > 20.0) fail_input("the map is empty");
  const double taps = static_cast<double>(std::get<int64_t>(request.parameters.at("taps")));
  const double error =
      (0.02 + 0.05 * std::abs(std::cbrt(bias) - std::cbrt(kBestBias))) * (taps > 32.0 ? 0.5 : 1.0);
  Frame frame = frame_of(technique_image(static_cast<float>(error)));
  frame.image.add_plane("texel_world", 0.25f);
  frame.parameters = request.parameters;
  return frame;
}

class Tune : public testing::Test {
 protected:
  Tune() {
    plan.technique = fake_technique("fake");
    plan.parameters = {bias_parameter(), taps_parameter()};
    plan.technique.parameters = default_values(plan.parameters);
    plan.presets = {{"engine", {{"bias_texels", 1.5}, {"taps", int64_t{64}}}},
                    {"medium", {{"bias_texels", 4.0}}}};
    plan.evaluations = 40;
    plan.seed = 7;
    plan.full = {kFakeWidth_px, kFakeHeight_px, &reference};
    scenes[0].scene.camera.up_world = {0, 0, 1};
  }

  TuneResult run() { return run_tune(scenes, plan, realtime, progress); }

  TunePlan plan;
  std::vector<SceneJob> scenes = {fake_scene("plate")};
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime{render};
  SilentProgress progress;
};

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

std::vector<std::string> views_of(const TuneResult& result, bool is_held_out) {
  std::vector<std::string> names;
  for (const ViewScore& score : result.best.scores) {
    if (score.is_held_out == is_held_out) names.push_back(score.view);
  }
  return names;
}

TEST_F(Tune, ScoresOnCamerasItDidNotTuneOn) {
  const TuneResult result = run();
  ASSERT_TRUE(result.best.held_out_ratio);
  EXPECT_THAT(views_of(result, false), testing::ElementsAre("plate", "plate, -13 deg", "plate, +13 deg",
                                                            "plate, -26 deg", "plate, +26 deg"));
  EXPECT_THAT(views_of(result, true),
              testing::ElementsAre("plate, -3.25 deg", "plate, +3.25 deg", "plate, -9.75 deg",
                                   "plate, +9.75 deg", "plate, -16.25 deg", "plate, +16.25 deg",
                                   "plate, -22.75 deg", "plate, +22.75 deg"));
  EXPECT_EQ(scenes[0].scene.camera.eye_world, glm::dvec3(0, 10, 0));  // put back
}

/// From the scene's own camera, which is 10 away from what it looks at.
double angle_deg_of(const Scene& scene) {
  return -std::asin(scene.camera.eye_world.x / 10.0) * 180.0 / std::numbers::pi;
}

/// A picture that depends on where it is seen from.
class Turning final : public Renderer {
 public:
  using Picture = std::function<Image(double angle_deg, const RenderRequest& request)>;
  explicit Turning(Picture picture) : picture_(std::move(picture)) {}
  Frame render(const Scene& scene, const RenderRequest& request, Progress&) override {
    return frame_of(picture_(angle_deg_of(scene), request));
  }

 private:
  Picture picture_;
};

/// Of a renderer that is wrong by 0.1 unless the bias is low, and then by what `error` says.
Turning better_with_low_bias(std::function<double(double angle_deg)> error) {
  return Turning([error](double angle_deg, const RenderRequest& request) {
    if (request.technique.empty()) return floor_image();
    const bool is_low = bias_of(request.parameters) < 2.0;
    return technique_image(static_cast<float>(is_low ? error(std::abs(angle_deg)) : 0.1));
  });
}

TEST_F(Tune, WhatHoldsOnTheSearchedCamerasAloneGoesBack) {
  plan.presets.clear();
  Turning renderer = better_with_low_bias([](double angle_deg) {
    const bool is_searched = std::abs(std::remainder(angle_deg, 13.0)) < 0.1;
    return is_searched ? 0.05 : 0.2;
  });
  const TuneResult result = run_tune(scenes, plan, renderer, progress);
  EXPECT_LT(result.full_trials.back().objective, 2.0);
  EXPECT_EQ(bias_of(result.best.values), 4.0);
}

TEST_F(Tune, GainsHaveTheIntervalOfTheCameras) {
  plan.presets.clear();
  Turning renderer = better_with_low_bias([](double angle_deg) { return 0.05 + 0.001 * angle_deg; });
  const TuneResult result = run_tune(scenes, plan, renderer, progress);
  ASSERT_TRUE(result.others[0].held_out_gain);
  const Interval& gain = *result.others[0].held_out_gain;
  // 0.5 - 0.01 a at a = 3.25, 9.75, 16.25 and 22.75 to both sides: standard deviation 0.0777, Student's t of 7: 2.365.
  EXPECT_NEAR(gain.value, 0.5 - 0.01 * 13.0, 1e-3);
  EXPECT_NEAR(gain.high - gain.value, 2.365 * 0.0777 / std::sqrt(8.0), 1e-3);
  EXPECT_NEAR(gain.value - gain.low, gain.high - gain.value, 1e-9);
}

TEST_F(Tune, CamerasStayWhereTheySeeTheShadow) {
  Turning truth([](double angle_deg, const RenderRequest&) {
    Image image = reference_image();
    const bool sees_shadow = angle_deg > -14.0 && angle_deg < 5.0;
    if (!sees_shadow) std::ranges::fill(image.plane("visibility"), 1.0f);
    return image;
  });
  plan.full.reference = &truth;
  const TuneResult result = run();
  EXPECT_THAT(views_of(result, false), testing::ElementsAre("plate", "plate, -6.5 deg", "plate, -13 deg"));
  EXPECT_THAT(views_of(result, true), testing::ElementsAre("plate, -1.625 deg", "plate, -4.875 deg",
                                                           "plate, -8.125 deg", "plate, -11.38 deg"));
}

TEST_F(Tune, ABlindCameraOnTheArcIsLeftOut) {
  for (const float everywhere : {0.0f, 1.0f}) {  // in a wall, in the open
    Turning truth([everywhere](double angle_deg, const RenderRequest&) {
      Image image = reference_image();
      if (std::abs(angle_deg - 13.0) < 1.0) std::ranges::fill(image.plane("visibility"), everywhere);
      return image;
    });
    plan.full.reference = &truth;
    EXPECT_THAT(views_of(run(), false),
                testing::ElementsAre("plate", "plate, -13 deg", "plate, -26 deg", "plate, +26 deg"));
  }
}

TEST_F(Tune, ATruthAndItsSurfacesAreRenderedOncePerCamera) {
  run();
  EXPECT_EQ(reference.requests.size(), 17u);  // searched 5, checked 4, held out 8
  const auto surfaces = std::ranges::count_if(
      realtime.requests, [](const RenderRequest& request) { return request.technique.empty(); });
  EXPECT_EQ(surfaces, 17);
}

TEST_F(Tune, OneCameraIsTunedOnAloneAndScoredElsewhere) {
  plan.cameras = 1;
  const TuneResult result = run();
  EXPECT_EQ(views_of(result, false), std::vector<std::string>{"plate"});
  EXPECT_EQ(views_of(result, true).size(), 8u);
}

TEST_F(Tune, AFailureOfTheMachineIsNoCameraThatSeesTooLittle) {
  reference = FakeRenderer([this](const RenderRequest&) {
    if (reference.requests.size() > 1) fail_environment("the disk is full");
    return frame_of(reference_image());
  });
  EXPECT_THROW(run(), Error);
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

TEST_F(Tune, FilesHoldWhatWasMeasured) {
  const TuneResult result = run();
  const std::string bias = to_text(result.best.values.at("bias_texels"));
  EXPECT_THAT(preset_toml(plan, result), HasSubstr("technique = \"fake\""));
  EXPECT_THAT(preset_toml(plan, result), HasSubstr("bias_texels = " + bias + "\n"));
  EXPECT_THAT(engine_block(plan, result), HasSubstr("bias_texels = " + bias + "  // "));
  EXPECT_THAT(engine_block(plan, result), HasSubstr("world units at 0.25 a texel"));
  const Json json = Json::parse(to_json_text(plan, result));
  EXPECT_EQ(json["best"]["parameters"]["bias_texels"],
            std::get<double>(result.best.values.at("bias_texels")));
  const Json& sweep = json["bias_sweep"][0];
  EXPECT_EQ(sweep["bias"].size(), sweep["objective"].size());
  EXPECT_EQ(sweep["bias"].size(), sweep["acne_share"].size());
}

TEST_F(Tune, TheEngineBlockNamesWhatEnginesLack) {
  Parameter plane;
  plane.name = "receiver_plane";
  plane.type = ParameterType::choice;
  plane.choices = {"none", "texel_center"};
  plane.default_value = std::string("none");
  plan.parameters.push_back(plane);
  TuneResult result;
  result.tuned = {"bias_texels", "receiver_plane"};
  result.texel_world = 0.25;
  result.best.values = {{"bias_texels", 2.0}, {"receiver_plane", std::string("texel_center")}};
  const std::string lacking = "// No engine's light settings have these";
  EXPECT_THAT(engine_block(plan, result),
              testing::AllOf(
                  HasSubstr("bias_texels = 2  // 0.5 world units at 0.25 a texel\n//   Unity URP Depth Bias"),
                  testing::ContainsRegex(lacking + ".*\nreceiver_plane = texel_center")));
  result.best.values["receiver_plane"] = std::string("none");
  EXPECT_THAT(engine_block(plan, result), testing::Not(HasSubstr(lacking)));
}

TEST_F(Tune, SaysWhatAnObjectiveLacks) {
  plan.objective = Objective::penumbra;  // the fakes' truth has no edge
  try {
    run();
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("plate has nothing that objective 'penumbra' measures"));
  }
}

TEST(DrawAndScore, ScoresInOrderBesideTheNextDraw) {
  std::vector<size_t> scored;
  std::vector<size_t> drawn;
  const auto frame = [&](size_t i) {
    drawn.push_back(i);
    return frame_of(technique_image(0.0f));
  };
  const auto score_until = [&](size_t last) {
    return [&scored, last](size_t i, const Frame& picture) {
      EXPECT_TRUE(picture.image.has("visibility"));
      scored.push_back(i);
      return i != last;
    };
  };
  draw_and_score(4, frame, score_until(9));
  EXPECT_THAT(scored, testing::ElementsAre(0, 1, 2, 3));
  scored.clear();
  drawn.clear();
  draw_and_score(5, frame, score_until(1));
  EXPECT_THAT(scored, testing::ElementsAre(0, 1));
  EXPECT_THAT(drawn, testing::ElementsAre(0, 1, 2));
  draw_and_score(0, frame, score_until(0));
  EXPECT_EQ(scored.size(), 2u);
  const auto broken = [](size_t, const Frame&) -> bool { fail_input("a NaN"); };
  EXPECT_THROW(draw_and_score(3, frame, broken), Error);
}

/// Acne below `acne`, peter-panning above `detached`.
SafeWindow window(double acne, double detached, size_t* measured = nullptr) {
  const MeasureWindow measure = [=](double bias) {
    if (measured != nullptr) ++*measured;
    return WindowPoint{bias, 0.1, bias < acne ? 0.02 : 0.0, bias > detached ? 0.03 : 0.0};
  };
  return find_window(bias_parameter(), measure, [] { return true; });
}

TEST(SafeWindows, LieBetweenAcneAndPeterPanning) {
  size_t measured = 0;
  const SafeWindow found = window(0.5, 3.0, &measured);
  ASSERT_TRUE(found.has_window());
  EXPECT_LE(measured, 16u);  // eight levels, and both ends halved four times
  // A 7th of the axis, halved four times: 0.009 cbrt(32) of the cube root.
  EXPECT_NEAR(std::cbrt(*found.from), std::cbrt(0.5), 0.03);
  EXPECT_NEAR(std::cbrt(*found.to), std::cbrt(3.0), 0.03);
  EXPECT_GE(*found.from, 0.5);
  EXPECT_LE(*found.to, 3.0);
  EXPECT_DOUBLE_EQ(*in_world_units(found.unit, 2.0, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(*in_texels(found.unit, 2.0, 0.25), 2.0);
  EXPECT_DOUBLE_EQ(*in_texels("world", 2.0, 0.25), 8.0);
  EXPECT_FALSE(in_texels("world", 2.0, 0.0));
  EXPECT_FALSE(in_texels("none", 2.0, 0.25));
}

TEST(SafeWindows, MayBeEmpty) {
  const SafeWindow crossed = window(3.0, 0.5);
  EXPECT_FALSE(crossed.has_window());
  EXPECT_TRUE(crossed.from && crossed.to);
  EXPECT_FALSE(window(100.0, 200.0).from);
  EXPECT_FALSE(window(0.0, -1.0).to);
}

TEST(SafeWindows, MayReachFromEndToEnd) {
  const SafeWindow all = window(0.0, 100.0);
  EXPECT_EQ(*all.from, 0.0);
  EXPECT_EQ(*all.to, 32.0);
}

Parameter size_parameter() {
  Parameter parameter;
  parameter.name = "light_size_scale";
  parameter.default_value = 1.0;
  parameter.min = 0.1;
  parameter.max = 10.0;
  parameter.scale = ParameterScale::log;
  parameter.unit = "none";
  parameter.group = "light";
  return parameter;
}

TEST(SafeWindows, OfALightSizeLieBetweenTooHardAndTooSoft) {
  // A kernel twice as wide as it should be at scale 1: right at a half, and a quarter of an octave to each side.
  const MeasureWindow measure = [](double scale) {
    const double octaves = std::log2(2.0 * scale);
    return WindowPoint{scale, 0.1, std::max(0.0, -octaves), std::max(0.0, octaves)};
  };
  const SafeWindow found = find_window(size_parameter(), measure, [] { return true; });
  EXPECT_EQ(found.kind, WindowKind::light_size);
  ASSERT_TRUE(found.has_window());
  EXPECT_NEAR(std::log2(2.0 * *found.from), -0.25, 0.1);
  EXPECT_NEAR(std::log2(2.0 * *found.to), 0.25, 0.1);
  EXPECT_GE(std::log2(2.0 * *found.from), -0.25);
  EXPECT_LE(std::log2(2.0 * *found.to), 0.25);
}

TEST_F(Tune, LengthsAreThoseOfTheSmallestScene) {
  Parameter length;
  length.name = "bias_world";
  length.default_value = std::string("0.01 diagonals");
  length.max = 0.5;
  length.unit = "world";
  length.group = "bias";
  length.is_relative_to_scene = true;
  plan.parameters.push_back(length);
  plan.technique.parameters = default_values(plan.parameters);
  plan.presets.push_back({"long", {{"bias_world", std::string("0.25 diagonals")}}});
  scenes.push_back(fake_scene("fence"));
  scenes[0].scene.bounds_world = {{0, 0, 0}, {0, 300, 400}};
  scenes[1].scene.bounds_world = {{0, 0, 0}, {0, 0, 20}};
  resolve_lengths(plan, scenes);
  EXPECT_EQ(plan.parameters.back().max, 10.0);
  EXPECT_EQ(plan.technique.parameters.at("bias_world"), ParameterValue(0.2));
  EXPECT_EQ(plan.presets.back().values.at("bias_world"), ParameterValue(5.0));
  EXPECT_THAT(plan.notes, testing::ElementsAre(HasSubstr("the smallest scene, 20 across")));
  plan.parameters.back() = length;
  plan.technique.parameters["bias_world"] = 11.0;
  EXPECT_THROW(resolve_lengths(plan, scenes), Error);
}

TEST(Objectives, ADestroyedPenumbraIsNoWidthOfNothing) {
  EXPECT_THROW(choose_objective("rsme"), Error);
  EXPECT_EQ(choose_objective("faults"), Objective::faults);
  const Image reference = reference_image();
  std::vector<uint8_t> mask(reference.pixel_count(), 1);
  EXPECT_FALSE(measure_objective(Objective::penumbra, technique_image(0.1f), reference, mask, true));
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a tuner could learn from the cameras it is judged on, or from such as see nothing.

#include "tests/unit/study/tune_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace umbrameter {
namespace {

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

}  // namespace
}  // namespace umbrameter

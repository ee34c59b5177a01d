// SPDX-License-Identifier: Apache-2.0
// A curve that counts the judge's noise, or the wrong points, would make the truth look worse or better than it is.

#include "lab/truth_curve.h"

#include "scenes/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace umbrameter {
namespace {

/// A surface everywhere, half lit; every pixel errs by `error`, the halves by as much to either side.
class FakeTruth final : public Renderer {
 public:
  FakeTruth(float error, float samples, int& pictures)
      : error_(error), samples_(samples), pictures_(pictures) {}

  Frame render(const Scene&, const RenderRequest& request, Progress&) override {
    ++pictures_;
    Frame frame;
    frame.image = Image(request.width_px, request.height_px);
    const auto fill = [&](const char* channel, float value) { frame.image.add_plane(channel, value); };
    fill("primitive_id", 0.0f);
    fill("visibility", 0.5f + error_);
    fill("half_a", 0.5f + error_);
    fill("half_b", 0.5f - error_);
    fill("visibility_se", std::abs(error_));
    fill("sample_count", samples_);
    return frame;
  }

 private:
  float error_;
  float samples_;
  int& pictures_;
};

TruthPoint point(const std::string& kind, double setting, double rmse) {
  return {kind, setting, {}, 0.0, Interval{rmse, rmse, rmse}};
}

TEST(TruthCurve, EverySettingIsRepeatedAndHeldAgainstTheLastTarget) {
  int pictures = 0;
  TruthPlan plan;
  plan.settings.push_back({"target_se", 0.1, std::make_unique<FakeTruth>(0.2f, 4.0f, pictures)});
  plan.settings.push_back({"target_se", 0.01, std::make_unique<FakeTruth>(0.0f, 64.0f, pictures)});
  plan.settings.push_back({"samples", 16, std::make_unique<FakeTruth>(0.1f, 16.0f, pictures)});
  plan.settings.push_back({"samples", 64, std::make_unique<FakeTruth>(0.05f, 64.0f, pictures)});
  plan.repetitions = 3;
  RenderRequest request;
  request.width_px = 64;
  request.height_px = 48;
  SilentProgress progress;
  const TruthCurve curve = measure_truth(Scene{}, request, plan, progress);
  EXPECT_EQ(pictures, 1 + 3 * 4);
  ASSERT_EQ(curve.points.size(), 4u);
  EXPECT_EQ(curve.points[0].kind, "target_se");
  EXPECT_NEAR(curve.points[0].rmse->value, 0.2, 1e-6);
  EXPECT_EQ(curve.points[0].rays_per_pixel, 4.0);
  EXPECT_NEAR(curve.points[2].rmse->value, 0.1, 1e-6);
  EXPECT_GE(curve.points[2].cpu_s.median, 0.0);
  EXPECT_NEAR(curve.exponent.value(), -0.5, 1e-5);
}

TEST(TruthCurve, TheExponentIsThatOfFixedSamples) {
  std::vector<TruthPoint> points{point("target_se", 0.01, 1.0),
                                 point("samples", 32, 3.0 * std::pow(32, -0.8))};
  EXPECT_FALSE(convergence_exponent(points));
  points.push_back(point("samples", 128, 3.0 * std::pow(128, -0.8)));
  points.push_back(point("samples", 512, 3.0 * std::pow(512, -0.8)));
  points.push_back(point("samples", 2048, 0.0));  // nothing left to measure
  EXPECT_NEAR(convergence_exponent(points).value(), -0.8, 1e-9);
}

}  // namespace
}  // namespace umbrameter

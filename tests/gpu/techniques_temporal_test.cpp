// SPDX-License-Identifier: Apache-2.0
// Techniques over frames: what their mean converges to, where it begins anew, and what is left of what moved.

#include "realtime/inspect.h"
#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace umbrameter::test {
namespace {

ParameterValues over(int64_t frames, int64_t taps, const ParameterValues& more = {}) {
  return with({{"map_size", int64_t{256}},
               {"history_frames", frames},
               {"taps", taps},
               {"history_limit", std::string("none")}},
              more);
}

double rms_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::pow(double{a[i]} - double{b[i]}, 2.0);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// The taps of frame after frame are those of one sequence: sixteen frames of four are one of sixty-four.
TEST(TemporalTechniques, AStillPictureIsThatOfAllTapsAtOnce) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const ParameterValues wide{{"radius_texels", 6.0}};
  const auto many = visibility(scene, "pcf_temporal", over(1, 64, wide));
  EXPECT_LT(largest_difference(visibility(scene, "pcf_temporal", over(16, 4, wide)), many), 1e-5);
  EXPECT_LT(largest_difference(visibility(scene, "pcf_temporal", over(64, 1, wide)), many), 1e-5);
  EXPECT_GT(largest_difference(visibility(scene, "pcf_temporal", over(8, 4, wide)), many), 1e-2);
}

// Single comparisons, so that a tap is 0 or 1. The mean square of random taps' error falls as 1 / N; of points spread evenly in the
// plane, about an edge, as N^-3/2: 64 and 512 times in 16 and 64 frames.
TEST(TemporalTechniques, TheErrorOfAStillPictureFallsWithItsFrames) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const ParameterValues wide{{"radius_texels", 12.0}, {"bilinear", false}};
  const auto limit = visibility(scene, "pcf_temporal", over(1, 1024, wide));
  const auto error = [&](int64_t frames) {
    return rms_difference(visibility(scene, "pcf_temporal", over(frames, 1, wide)), limit);
  };
  const double one = error(1);
  EXPECT_LT(std::pow(error(16) / one, 2.0), 1.0 / 32.0);
  EXPECT_LT(std::pow(error(64) / one, 2.0), 1.0 / 256.0);
}

TEST(TemporalTechniques, SoftShadowsOverFramesNearTheTruth) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::disk, 1.2);
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
  const auto error = [&](int64_t frames) {
    const Frame frame = render(half_plane_scene(light), "pcss_temporal",
                               {{"map_size", int64_t{512}},
                                {"history_frames", frames},
                                {"search_taps", int64_t{16}},
                                {"filter_taps", int64_t{4}},
                                {"history_limit", std::string("none")}});
    return floor_error(frame, truth).rmse;
  };
  const double one = error(1), many = error(32);
  EXPECT_LT(many, 0.5 * one);  // the rest is what the plane at the mean distance leaves
  EXPECT_LT(many, 0.025);
}

// A texel's middle lies anywhere within half a texel of the receiver: so does the edge that the mean over frames shows.
TEST(TemporalTechniques, MovedMapsShowTheShareOfATexel) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::disk, 0.02));
  const auto render_over = [&](int64_t frames) {
    return render(scene, "hard_temporal",
                  {{"map_size", int64_t{64}},
                   {"history_frames", frames},
                   {"history_limit", std::string("none")},
                   {"map_fit", std::string("scene")}});
  };
  const Frame one = render_over(1), many = render_over(128);
  // All of the floor is as far along the light's axis: a texel is as wide everywhere. From the first floor pixel to the last.
  const auto x = many.image.plane("position.x"), y = many.image.plane("position.y");
  const auto u = many.image.plane("texel.x"), hit = many.image.plane("primitive_id");
  std::optional<size_t> leftmost, rightmost;
  for (size_t i = 0; i < x.size(); ++i) {
    if (hit[i] < 0.0f || std::abs(y[i]) >= 1e-4f) continue;
    if (!leftmost || x[i] < x[*leftmost]) leftmost = i;
    if (!rightmost || x[i] > x[*rightmost]) rightmost = i;
  }
  ASSERT_TRUE(leftmost && rightmost);
  const size_t low = *leftmost, high = *rightmost;
  const double texel = std::abs((double{x[high]} - double{x[low]}) / (double{u[high]} - double{u[low]}));
  const auto ramp = [&](const glm::dvec3& p) { return std::clamp(0.5 + p.x / texel, 0.0, 1.0); };
  EXPECT_LT(floor_error(many, ramp).rmse, 0.02);
  EXPECT_GT(floor_error(one, ramp).rmse, 0.1);
}

/// How many frames the mean of each surface pixel is of.
std::vector<float> frames_of(Scene scene, std::string_view motion, const ParameterValues& parameters) {
  const auto renderer = make_realtime_renderer(
      {source_dir() / "realtime" / "techniques", source_dir() / "realtime" / "shaders", ""});
  scene.motion = standard_motion(motion, scene);
  RenderRequest request;
  request.width_px = 160;
  request.height_px = 90;
  request.technique = "pcf_temporal";
  request.parameters = parameters;
  SilentProgress progress;
  const Image mean = dump_resource(*renderer, scene, request, {"mean", 0, 0}, progress);
  const Image covered = dump_resource(*renderer, scene, request, {"gbuffer.position", 0, 0}, progress);
  std::vector<float> frames;
  for (size_t i = 0; i < mean.plane("G").size(); ++i)
    if (covered.plane("A")[i] != 0.0f) frames.push_back(mean.plane("G")[i]);
  return frames;
}

TEST(TemporalTechniques, HistoryBeginsAnewAtACut) {
  UMBRAMETER_REQUIRE_GL();
  const auto all_are = [](const std::vector<float>& frames, float count) {
    return !frames.empty() && std::ranges::all_of(frames, [&](float n) { return n == count; });
  };
  EXPECT_TRUE(all_are(frames_of(plate_scene(), "cut", over(8, 1)), 1.0f));
  EXPECT_TRUE(all_are(frames_of(plate_scene(), "still", over(8, 1)), 8.0f));
  EXPECT_TRUE(all_are(frames_of(plate_scene(), "light", over(8, 1)), 8.0f));
}

// The camera shows 3.6 new columns and 1.4 new rows a frame; behind the plate floor comes into view besides.
TEST(TemporalTechniques, WhatComesIntoViewHasNoHistory) {
  UMBRAMETER_REQUIRE_GL();
  const std::vector<float> frames = frames_of(plate_scene(), "pan", over(8, 1));
  const auto share_of = [&](float count) {
    return static_cast<double>(std::count_if(frames.begin(), frames.end(),
                                             [&](float n) { return std::abs(n - count) < 0.5f; })) /
           static_cast<double>(frames.size());
  };
  EXPECT_GT(share_of(8.0f), 0.7);
  EXPECT_GT(share_of(1.0f), 3.0 / 160.0);
  EXPECT_LT(share_of(1.0f), 0.1);
}

TEST(TemporalTechniques, LimitsShortenWhatAMovedShadowLeaves) {
  UMBRAMETER_REQUIRE_GL();
  const auto ghost = [](const std::string& limit) {
    Scene scene = plate_scene();
    const ParameterValues parameters =
        over(16, 8, {{"radius_texels", 4.0}, {"history_limit", limit}, {"limit_deviations", 1.0}});
    const auto still = visibility(scene, "pcf_temporal", parameters);
    scene.motion = standard_motion("light", scene);
    return rms_difference(visibility(scene, "pcf_temporal", parameters), still);
  };
  const double unlimited = ghost("none");
  EXPECT_GT(unlimited, 0.02);
  EXPECT_LT(ghost("range"), 0.85 * unlimited);
  EXPECT_LT(ghost("deviations"), 0.7 * unlimited);
}

}  // namespace
}  // namespace umbrameter::test

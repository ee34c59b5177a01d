// SPDX-License-Identifier: Apache-2.0
// Rays to the light: what they converge to, how fast, with which lights; and what the filter over frames and neighbours makes of one.

#include "realtime/inspect.h"
#include "realtime/realtime.h"
#include "reference/reference.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter::test {
namespace {

constexpr LightType kAllLights[] = {LightType::rect, LightType::disk, LightType::sphere, LightType::sun};

ParameterValues rays(int64_t count) {
  return {{"samples", count}};
}

double half_plane_error(const Light& light, const std::string& technique, const ParameterValues& values) {
  const Frame frame = render(half_plane_scene(light), technique, values);
  return floor_error(frame, [&](const glm::dvec3& p) { return half_plane_visibility(light, p); }).rmse;
}

TEST(RayTraced, ConvergesToTheClosedFormUnderEveryLight) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : kAllLights)
    EXPECT_LT(half_plane_error(light_at_4(type, 1.2), "ray_traced", rays(64)), 0.01) << to_text(type);
}

// About an edge the error of points spread evenly in the plane falls as N^-3/4; of random ones as N^-1/2, which is 8 from 1 to 64.
TEST(RayTraced, ErrsLessWithMoreRaysThanRandomPointsWould) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : kAllLights) {
    const Light light = light_at_4(type, 1.2);
    const double one = half_plane_error(light, "ray_traced", rays(1));
    EXPECT_GT(one / half_plane_error(light, "ray_traced", rays(16)), 6.0) << to_text(type);
    EXPECT_GT(one / half_plane_error(light, "ray_traced", rays(64)), 16.0) << to_text(type);
  }
}

TEST(RayTraced, KnowsThePlatesShadowExactly) {
  UMBRAMETER_REQUIRE_GL();
  const Frame frame = render(plate_scene(), "ray_traced", rays(64));
  EXPECT_LT(floor_error(frame, plate_visibility).rmse, 0.012);
}

double truth_error(const Scene& scene, int64_t count) {
  const Frame frame = render(scene, "ray_traced", rays(count));
  RenderRequest request;
  request.width_px = 160;
  request.height_px = 90;
  SilentProgress progress;
  const Frame truth =
      make_reference_renderer({.samples_per_pixel = 1024, .target_se = {}})->render(scene, request, progress);
  const auto a = frame.image.plane("visibility"), b = truth.image.plane("visibility");
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::pow(double{a[i]} - double{b[i]}, 2.0);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// Holes, instances and curved surfaces, all of which Embree sees by itself.
TEST(RayTraced, AgreesWithTheTruth) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : kAllLights)
    EXPECT_LT(truth_error(busy_scene(light_at_4(type, 0.5)), 64), 0.015) << to_text(type);
  const Scene forest =
      instanced_scene(light_at_4(LightType::disk, 0.5), {.is_smooth = true, .has_leaves = true});
  EXPECT_LT(truth_error(forest, 64), 0.015);
}

// Everything but the plate's shadow is lit wholly: no ray meets the triangle that it leaves.
TEST(RayTraced, MeetsNotTheTriangleThatItLeaves) {
  UMBRAMETER_REQUIRE_GL();
  const Frame frame = render(plate_scene(), "ray_traced", rays(16));
  const auto v = frame.image.plane("visibility"), x = frame.image.plane("position.x");
  const auto y = frame.image.plane("position.y"), z = frame.image.plane("position.z");
  size_t lit = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (frame.image.plane("primitive_id")[i] < 0.0f || std::abs(y[i]) > 1e-4f) continue;
    if (plate_visibility({x[i], y[i], z[i]}) < 1.0) continue;
    EXPECT_EQ(v[i], 1.0f);
    ++lit;
  }
  EXPECT_GT(lit, v.size() / 4);
}

TEST(Svgf, LeavesLittleOfTheNoiseOfOneRay) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : {LightType::rect, LightType::sun}) {
    const Light light = light_at_4(type, 1.2);
    const double one = half_plane_error(light, "ray_traced", rays(1));
    EXPECT_LT(half_plane_error(light, "ray_traced_svgf", {}), 0.1 * one) << to_text(type);
  }
}

// Where nothing is noisy the filter changes nothing: edges of hard shadows stay.
TEST(Svgf, KeepsWhatHasNoNoise) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 1e-4));
  const auto sharp = visibility(scene, "ray_traced", rays(4));
  EXPECT_LT(mean_difference(visibility(scene, "ray_traced_svgf"), sharp), 1e-3);
}

// Noise is what two seeds differ by.
TEST(Svgf, FiltersMoreWithMoreLevels) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::rect, 1.2));
  const auto noise = [&](int64_t levels) {
    const ParameterValues values{{"levels", levels}, {"history_frames", int64_t{1}}};
    return mean_difference(visibility(scene, "ray_traced_svgf", values, 1),
                           visibility(scene, "ray_traced_svgf", values, 2));
  };
  EXPECT_LT(noise(3),
            0.5 * noise(1));  // of a single frame further levels leave a grid, whose pixels they skip
}

/// How many frames the mean of each pixel of the floor is of.
std::vector<float> frames_of(Scene scene, std::string_view motion) {
  const auto renderer = make_realtime_renderer(
      {source_dir() / "realtime" / "techniques", source_dir() / "realtime" / "shaders", ""});
  scene.motion = standard_motion(motion, scene);
  const RenderRequest request{160, 90, 1, "ray_traced_svgf", {}};
  SilentProgress progress;
  const Image kept = dump_resource(*renderer, scene, request, {"kept", 0, 0}, progress);
  const Image covered = dump_resource(*renderer, scene, request, {"gbuffer.position", 0, 0}, progress);
  std::vector<float> frames;
  for (size_t i = 0; i < kept.plane("G").size(); ++i)
    if (covered.plane("A")[i] != 0.0f) frames.push_back(kept.plane("G")[i]);
  return frames;
}

TEST(Svgf, BeginsAnewWhereSurfacesComeIntoView) {
  UMBRAMETER_REQUIRE_GL();
  const auto share_of = [](const std::vector<float>& frames, float count) {
    const auto found = std::ranges::count_if(frames, [&](float n) { return std::abs(n - count) < 0.5f; });
    return static_cast<double>(found) / static_cast<double>(frames.size());
  };
  EXPECT_EQ(share_of(frames_of(plate_scene(), "still"), 5.0f), 1.0);
  EXPECT_EQ(share_of(frames_of(plate_scene(), "cut"), 1.0f), 1.0);
  const std::vector<float> pan = frames_of(plate_scene(), "pan");
  EXPECT_GT(share_of(pan, 5.0f), 0.7);
  EXPECT_GT(share_of(pan, 1.0f), 3.0 / 160.0);
}

/// Of the picture averaged over 4 x 4 pixels: what is left of noise that the eye blurs.
double coarse_error(const std::vector<float>& v, const std::vector<float>& limit) {
  constexpr size_t kWidth = 160, kHeight = 88, kBlock = 4;
  double sum = 0.0;
  for (size_t y = 0; y < kHeight; y += kBlock) {
    for (size_t x = 0; x < kWidth; x += kBlock) {
      double error = 0.0;
      for (size_t i = 0; i < kBlock * kBlock; ++i) {
        const size_t at = (y + i / kBlock) * kWidth + x + i % kBlock;
        error += (double{v[at]} - double{limit[at]}) / (kBlock * kBlock);
      }
      sum += error * error;
    }
  }
  return std::sqrt(sum * kBlock * kBlock / (kWidth * kHeight));
}

TEST(BlueNoise, LeavesLessErrorThanWhiteNoiseWhenNeighboursAreAveraged) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const auto limit = visibility(scene, "ray_traced", rays(64));
  const auto blue = visibility(scene, "ray_traced", with(rays(1), {{"offset_noise", std::string("blue")}}));
  double pixel = 0.0;
  for (size_t i = 0; i < blue.size(); ++i) pixel += std::pow(double{blue[i]} - double{limit[i]}, 2.0);
  pixel = std::sqrt(pixel / static_cast<double>(blue.size()));
  EXPECT_LT(coarse_error(blue, limit), 0.8 * pixel / 4.0);  // white noise leaves a quarter over 16 pixels
}

TEST(BlueNoise, ConvergesToTheSameOverFrames) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const auto over = [](const std::string& noise) {
    return ParameterValues{
        {"map_size", int64_t{256}}, {"history_frames", int64_t{64}},        {"taps", int64_t{4}},
        {"radius_texels", 6.0},     {"history_limit", std::string("none")}, {"offset_noise", noise}};
  };
  const auto one = visibility(scene, "pcf_temporal", over("interleaved"));
  const auto other = visibility(scene, "pcf_temporal", over("blue"));
  EXPECT_LT(mean_difference(one, other), 2e-3);
  EXPECT_GT(largest_difference(one, other), 0.0);
}

}  // namespace
}  // namespace umbrameter::test

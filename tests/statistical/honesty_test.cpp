// SPDX-License-Identifier: Apache-2.0
// The error bars, the two halves and the stopping rule: without these, verdicts built on them mean nothing.

#include "core/error.h"
#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

Scene ramp_scene(double light_size) {
  Scene scene = floor_under(rect_light_above({0, kLightHeight, 0}, {light_size, light_size}), 0.4);
  add_half_plane(scene);
  finish_scene(scene);
  return scene;
}

const Truth kRamp = in_penumbra([](const glm::dvec3& p) { return half_plane_square(p.x, 1.0); });

TEST(Honesty, a_light_five_percent_too_large_is_noticed) {
  const Frame right = render_reference(ramp_scene(1.0), {.samples_per_pixel = 1024});
  const Frame wrong = render_reference(ramp_scene(1.05), {.samples_per_pixel = 1024});
  EXPECT_EQ(objection(compare(right, kRamp)), "");
  EXPECT_NE(objection(compare(wrong, kRamp)), "");
}

TEST(Honesty, an_error_bar_too_small_by_a_fifth_is_noticed) {
  Frame frame = render_reference(ramp_scene(1.0));
  for (float& se : frame.image.plane("visibility_se")) se *= 0.8f;
  EXPECT_NE(objection(compare(frame, kRamp)), "");
}

TEST(Honesty, normalised_errors_spread_like_student_t_with_seven_degrees) {
  // E z^2 = 7/5 for Gaussian means; edges give flatter ones, but never tails that double it.
  const Agreement agreement = compare(render_reference(ramp_scene(1.0)), kRamp);
  EXPECT_GT(agreement.z_second_moment, 1.0);
  EXPECT_LT(agreement.z_second_moment, 2.0 * 7.0 / 5.0);
}

TEST(Honesty, halves_err_independently_and_average_to_the_whole) {
  const Frame frame = render_reference(ramp_scene(1.0));
  const auto a = frame.image.plane("half_a");
  const auto b = frame.image.plane("half_b");
  const auto whole = frame.image.plane("visibility");
  double aa = 0.0, bb = 0.0, ab = 0.0, a_sum = 0.0, b_sum = 0.0;
  double n = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_NEAR(0.5 * (a[i] + b[i]), whole[i], 1e-6);
    const auto truth = kRamp(position_of(frame, i));
    if (!truth) continue;
    const double ea = a[i] - *truth;
    const double eb = b[i] - *truth;
    aa += ea * ea;
    bb += eb * eb;
    ab += ea * eb;
    a_sum += ea;
    b_sum += eb;
    n += 1.0;
  }
  // A correlation of independent errors is normal with deviation 1/sqrt(n); a mean's is rms/sqrt(n).
  EXPECT_LT(std::abs(ab / std::sqrt(aa * bb)), 4.0 / std::sqrt(n));
  EXPECT_LT(std::abs(a_sum), 4.0 * std::sqrt(aa));
  EXPECT_LT(std::abs(b_sum), 4.0 * std::sqrt(bb));
}

TEST(Honesty, neighbouring_pixels_err_independently) {
  const Frame frame = render_reference(ramp_scene(1.0));
  const auto v = frame.image.plane("visibility");
  double squares = 0.0, products = 0.0, n = 0.0;
  for (size_t i = 0; i + 1 < v.size(); ++i) {
    const auto here = kRamp(position_of(frame, i));
    const auto next = kRamp(position_of(frame, i + 1));
    if (!here || !next) continue;
    squares += (v[i] - *here) * (v[i] - *here);
    products += (v[i] - *here) * (v[i + 1] - *next);
    n += 1.0;
  }
  EXPECT_LT(std::abs(products / squares), 4.0 / std::sqrt(n));
}

TEST(Honesty, error_falls_at_least_with_the_root_of_the_samples) {
  const Scene scene = ramp_scene(1.0);
  const Agreement few = compare(render_reference(scene, {.samples_per_pixel = 64}), kRamp);
  const Agreement many = compare(render_reference(scene, {.samples_per_pixel = 1024}), kRamp);
  const double noise = 4.0 * (few.variance_ratio_sd + many.variance_ratio_sd);
  EXPECT_GT(few.rmse / many.rmse, std::sqrt(1024.0 / 64.0) * (1.0 - 0.5 * noise));
}

TEST(Honesty, another_seed_gives_another_equally_good_picture) {
  const Scene scene = ramp_scene(1.0);
  const Frame one = render_reference(scene, {.seed = 1});
  const Frame two = render_reference(scene, {.seed = 0x100000001});  // differs in the upper half only
  EXPECT_FALSE(std::ranges::equal(one.image.plane("visibility"), two.image.plane("visibility")));
  EXPECT_EQ(objection(compare(two, kRamp)), "");
}

TEST(Honesty, thread_count_does_not_change_a_bit) {
  const Scene scene = ramp_scene(1.0);
  const Frame one = render_reference(scene, {.side_px = 50, .threads = 1, .target_se = 0.01});
  const Frame two = render_reference(scene, {.side_px = 50, .threads = 2, .target_se = 0.01});
  EXPECT_EQ(one.image.planes, two.image.planes);
}

TEST(Honesty, target_is_met_with_fewer_samples_where_light_is_plain) {
  const double target = 0.01;
  const Frame frame = render_reference(ramp_scene(1.0), {.samples_per_pixel = 4096, .target_se = target});
  EXPECT_THAT(frame.warnings, testing::IsEmpty());
  const auto se = frame.image.plane("visibility_se");
  const auto count = frame.image.plane("sample_count");
  // Each half stops by what the other shows, so single error bars scatter about what was promised.
  double se2 = 0.0;
  for (const float s : se) se2 += static_cast<double>(s) * s;
  EXPECT_LT(std::sqrt(se2 / static_cast<double>(se.size())), target);
  EXPECT_LT(*std::ranges::max_element(se), 2.0 * target);
  EXPECT_EQ(*std::ranges::min_element(count), 0.0f);  // fully lit, proven
  EXPECT_GT(*std::ranges::max_element(count), 128.0f);
  EXPECT_LT(*std::ranges::max_element(count), 4096.0f);
  // Stopping on a lucky small error bar would make the true error exceed the target.
  EXPECT_LT(compare(frame, kRamp).rmse, target);
}

TEST(Honesty, a_target_out_of_reach_is_reported) {
  const Frame frame = render_reference(ramp_scene(1.0), {.samples_per_pixel = 200, .target_se = 1e-4});
  EXPECT_THAT(frame.warnings, testing::ElementsAre(testing::HasSubstr("standard error above 0.0001")));
  const auto count = frame.image.plane("sample_count");
  EXPECT_TRUE(std::ranges::all_of(count, [](float c) { return c == 0.0f || c == 200.0f; }));
  EXPECT_EQ(*std::ranges::max_element(count), 200.0f);
}

TEST(Honesty, sample_counts_round_up_to_whole_replicates) {
  const Frame frame = render_reference(ramp_scene(1.0), {.side_px = 4, .samples_per_pixel = 100});
  EXPECT_EQ(*std::ranges::max_element(frame.image.plane("sample_count")), 104.0f);
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  return "no error";
}

TEST(Honesty, impossible_requests_are_named) {
  const Scene scene = ramp_scene(1.0);
  EXPECT_EQ(message_of([&] { render_reference(scene, {.side_px = 0}); }),
            "resolution is 0x0 (each side is 1 to 16384)");
  EXPECT_EQ(message_of([&] { render_reference(scene, {.side_px = 16385}); }),
            "resolution is 16385x16385 (each side is 1 to 16384)");
  EXPECT_EQ(message_of([&] { render_reference(scene, {.samples_per_pixel = 0}); }),
            "samples_per_pixel is 0 (choose 1 to 1048576)");
  EXPECT_EQ(message_of([&] { render_reference(scene, {.target_se = -1.0}); }),
            "target_se is -1 (choose a number between 0 and 1)");
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a tuner could promise a window that is not there, or deny one that is.

#include "lab/draw_and_score.h"
#include "tests/unit/study/tune_fixture.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace umbrameter {
namespace {

using testing::HasSubstr;

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

TEST(SafeWindows, EndWhereShadowsAreDetachedWhateverLooksLikeAcneBeyond) {
  std::set<double> tried;
  const MeasureWindow measure = [&](double bias) {
    tried.insert(bias);
    const bool looks_like_acne = bias < 0.5 || bias > 15.0;
    return WindowPoint{bias, 0.1, looks_like_acne ? 0.02 : 0.0, bias > 3.0 ? 0.03 : 0.0};
  };
  const SafeWindow found = find_window(bias_parameter(), measure, [] { return true; });
  ASSERT_TRUE(found.has_window());
  EXPECT_NEAR(std::cbrt(*found.from), std::cbrt(0.5), 0.03);
  EXPECT_NEAR(std::cbrt(*found.to), std::cbrt(3.0), 0.03);
  EXPECT_LT(*tried.rbegin(), 6.1);  // (4/7)^3 of 32 is the first level above 3
}

TEST(SafeWindows, MayReachFromEndToEnd) {
  const SafeWindow all = window(0.0, 100.0);
  EXPECT_EQ(*all.from, 0.0);
  EXPECT_EQ(*all.to, 32.0);
}

TEST(SafeWindows, BeginAtTheEndsThatHoldBesideOtherValues) {
  const SafeWindow before = window(0.5, 3.0);
  const auto again = [&](double acne, double detached, size_t& measured) {
    const MeasureWindow measure = [=, &measured](double bias) {
      ++measured;
      const bool looks_like_acne = bias < acne || bias > 5.0 * detached;
      return WindowPoint{bias, 0.1, looks_like_acne ? 0.02 : 0.0, bias > detached ? 0.03 : 0.0};
    };
    return find_window(
        bias_parameter(), measure, [] { return true; }, &before);
  };
  size_t same_count = 0, moved_count = 0;
  const SafeWindow same = again(0.5, 3.0, same_count);
  EXPECT_EQ(same_count, 5u);  // both ends, their neighbours beyond, the middle
  EXPECT_EQ(same.from, before.from);
  EXPECT_EQ(same.to, before.to);
  // Elsewhere they are found as if nothing had been known, or between what is known.
  for (const auto& [acne, detached] : {std::pair(0.2, 3.0), std::pair(0.5, 0.9), std::pair(0.02, 0.3)}) {
    const SafeWindow moved = again(acne, detached, moved_count);
    ASSERT_TRUE(moved.has_window()) << acne;
    EXPECT_NEAR(std::cbrt(*moved.from), std::cbrt(acne), 0.03);
    EXPECT_NEAR(std::cbrt(*moved.to), std::cbrt(detached), 0.03);
  }
  EXPECT_GT(moved_count, 3u * 5u);
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

TEST(Objectives, ADestroyedPenumbraIsNoWidthOfNothing) {
  const Image reference = reference_image();
  std::vector<uint8_t> mask(reference.pixel_count(), 1);
  EXPECT_FALSE(measure_objective({"penumbra"}, technique_image(0.1f), reference, mask, true));
  EXPECT_FALSE(measure_objective({"width_error_octaves"}, technique_image(0.1f), reference, mask, true));
}

TEST(Objectives, AreNamedOnesAndRowsThatAPictureGives) {
  for (const char* name :
       {"rmse", "penumbra", "faults", "worst_pixels_rmse", "over_shadowing", "penumbra.rmse"})
    EXPECT_EQ(choose_objective(name), Objective{name});
  EXPECT_EQ(unit_of(choose_objective("over_shadowing")), "visibility");
  const auto message_of = [](const char* name) {
    try {
      choose_objective(name);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(message_of("over_shadowign"), HasSubstr("did you mean 'over_shadowing'?"));
  EXPECT_THAT(message_of("flicker"), HasSubstr("it needs a sequence of pictures"));
  EXPECT_THAT(message_of("time_ms"), HasSubstr("it needs a timing"));
  EXPECT_THAT(message_of("psnr_db"), HasSubstr("(try rmse or ssim)"));
}

TEST(Objectives, ARowIsItsDistanceFromRight) {
  const Image reference = reference_image(), test = technique_image(0.1f);
  std::vector<uint8_t> mask(reference.pixel_count(), 1);
  const auto of = [&](const char* name) { return measure_objective({name}, test, reference, mask, true); };
  const double bias = of("bias").value().value;
  EXPECT_GT(bias, 0.0);
  EXPECT_NEAR(bias, std::abs(*measure_visibility_error(test, reference, mask).bias), 1e-12);
  EXPECT_NEAR(of("over_shadowing").value().value + of("under_shadowing").value().value,
              of("mae").value().value, 1e-12);
  EXPECT_GE(of("worst_pixels_rmse").value().value, of("mae").value().value);
  std::ranges::fill(mask, uint8_t{0});
  EXPECT_FALSE(of("bias"));
}

}  // namespace
}  // namespace umbrameter

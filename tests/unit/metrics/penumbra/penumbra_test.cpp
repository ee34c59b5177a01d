// SPDX-License-Identifier: Apache-2.0
// Without these, a width error could be an artefact of the walk, the fit or the view.
#include "metrics/penumbra/penumbra.h"

#include "core/error.h"
#include "tests/unit/metrics/synthetic.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::disk_ramp;
using testing::everywhere;
using testing::floor_from_above;
using testing::floor_in_perspective;
using testing::lit_floor;

size_t count(const PenumbraError& error, ProfileOutcome outcome) {
  return error.outcomes[static_cast<size_t>(outcome)];
}

PenumbraError measure(const Image& test, const Image& reference) {
  return measure_penumbra(test, reference, everywhere(reference));
}

std::vector<double> reference_widths(const PenumbraError& error) {
  std::vector<double> widths;
  for (const PenumbraProfile& profile : error.profiles) {
    if (profile.outcome == ProfileOutcome::accepted) widths.push_back(profile.reference_width_world);
  }
  return widths;
}

// Straight edge through (x0, z0), turned by `angle_rad`, lit on its positive side.
testing::FloorField edge(double x0, double z0, double angle_rad, double width) {
  return [=](double x, double z) {
    return box_ramp((x - x0) * std::cos(angle_rad) + (z - z0) * std::sin(angle_rad), width);
  };
}

class KnownWidth : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(KnownWidth, IsMeasuredWithinTwoPercent) {
  const auto [width_px, angle_rad] = GetParam();
  const double pixel = 0.01;
  const Image reference =
      lit_floor(floor_from_above(256, 256, pixel), edge(1.28, 1.28, angle_rad, width_px * pixel));
  const PenumbraError error = measure(reference, reference);
  const std::vector<double> widths = reference_widths(error);
  ASSERT_GT(widths.size(), 5u);
  for (const PenumbraProfile& profile : error.profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    // Of a stretch, which the picture's rim leaves, fewer pixels tell.
    const double tolerance = profile.is_partial ? 0.04 : 0.02;
    EXPECT_NEAR(profile.reference_width_world / (width_px * pixel), 1.0, tolerance);
    if (!profile.is_partial) {
      EXPECT_NEAR(profile.reference_width_px / width_px, 1.0, tolerance);
    }
    EXPECT_NEAR(profile.reference_width_10_90_world / (0.8 * width_px * pixel), 1.0, tolerance);
  }
  EXPECT_EQ(error.width_octaves->rmse, 0.0);
  EXPECT_EQ(error.offset_world->rmse, 0.0);
}

INSTANTIATE_TEST_SUITE_P(WidthsAndAngles, KnownWidth,
                         ::testing::Combine(::testing::Values(20.0, 45.0, 90.0),
                                            ::testing::Values(0.0, 0.4, 0.785, 2.0, 4.0)));

TEST(Penumbra, ADiskLightIsAsWideAsItsSecondMoment) {
  // sigma = w / 4, so sqrt(12) sigma = .866 w; 10-90 is .687 w.
  const Image reference =
      lit_floor(floor_from_above(256, 64, 1.0), [](double x, double) { return disk_ramp(x - 128.0, 80.0); });
  const PenumbraError error = measure(reference, reference);
  ASSERT_TRUE(error.width_octaves);
  for (const PenumbraProfile& profile : error.profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    EXPECT_NEAR(profile.reference_width_world, std::sqrt(12.0) / 4.0 * 80.0, 0.02 * 69.3);
    EXPECT_NEAR(profile.reference_width_10_90_world, 0.687 * 80.0, 0.02 * 55.0);
  }
}

TEST(Penumbra, NoiseOfTheReferenceDoesNotNarrowIt) {
  const Image surface = floor_from_above(256, 128, 1.0);
  const auto field = edge(128.0, 64.0, 0.3, 60.0);
  const PenumbraError error = measure(lit_floor(surface, field), lit_floor(surface, field, 1024));
  ASSERT_TRUE(error.width_octaves);
  const auto widths = spread_of(reference_widths(error));
  EXPECT_NEAR(widths->median / 60.0, 1.0, 0.02);
  EXPECT_NEAR(error.width_octaves->median, 0.0, 0.03);
}

TEST(Penumbra, WidthIsMeasuredOnTheFloorNotInThePicture) {
  // Widths 2 at 6 to 10 units of distance, seen at 23 to 42 degrees.
  const Image surface = floor_in_perspective(640, 480);
  for (const double angle_rad : {0.0, 0.7, 1.5708}) {
    const Image reference = lit_floor(surface, edge(0.0, 7.0, angle_rad, 2.0));
    const PenumbraError error = measure(reference, reference);
    const std::vector<double> widths = reference_widths(error);
    ASSERT_GT(widths.size(), 5u) << angle_rad;
    for (const double width : widths) EXPECT_NEAR(width / 2.0, 1.0, 0.02) << angle_rad;
  }
}

TEST(Penumbra, AWiderTestIsThatManyOctavesWider) {
  const Image surface = floor_from_above(256, 64, 0.1);
  const Image reference = lit_floor(surface, edge(12.8, 3.2, 0.2, 3.0));
  for (const double factor : {0.5, 1.5, 2.0}) {
    const PenumbraError error = measure(lit_floor(surface, edge(12.8, 3.2, 0.2, 3.0 * factor)), reference);
    ASSERT_TRUE(error.width_octaves) << factor;
    EXPECT_NEAR(error.width_octaves->median, std::log2(factor), 0.02) << factor;
    EXPECT_NEAR(error.width_octaves->rmse, std::abs(std::log2(factor)), 0.02) << factor;
    EXPECT_NEAR(error.width_10_90_octaves->median, std::log2(factor), 0.03) << factor;
    EXPECT_NEAR(error.offset_world->rmse, 0.0, 0.02) << factor;
  }
}

TEST(Penumbra, ALargerShadowHasAPositiveOffset) {
  const Image surface = floor_from_above(256, 64, 0.1);
  const Image reference = lit_floor(surface, edge(12.8, 3.2, 0.0, 3.0));
  const Image larger = lit_floor(surface, edge(13.2, 3.2, 0.0, 3.0));  // lit side begins 0.4 further on
  EXPECT_NEAR(measure(larger, reference).offset_world->median, 0.4, 0.01);
  EXPECT_NEAR(measure(reference, larger).offset_world->median, -0.4, 0.01);
  EXPECT_NEAR(measure(larger, reference).width_octaves->median, 0.0, 0.01);
}

TEST(Penumbra, AHardEdgeIsThreeOctavesTooNarrowInPicturesOfAnySize) {
  // One edge of .32 on a floor of 1.28 x .32.
  for (const int size : {1, 2, 4, 8}) {
    const Image surface = floor_from_above(64 * size, 16 * size, 0.02 / size);
    for (const double angle_rad : {0.0, 0.35}) {
      const Image reference = lit_floor(surface, edge(0.64, 0.16, angle_rad, 0.32));
      const Image hard = lit_floor(surface, edge(0.64, 0.16, angle_rad, 1e-6));
      const PenumbraError error = measure(hard, reference);
      ASSERT_TRUE(error.width_octaves) << size;
      EXPECT_EQ(error.width_octaves->median, -3.0) << size << ", " << angle_rad;
      EXPECT_EQ(error.width_10_90_octaves->median, -3.0) << size << ", " << angle_rad;
      const PenumbraError half = measure(lit_floor(surface, edge(0.64, 0.16, angle_rad, 0.16)), reference);
      EXPECT_NEAR(half.width_octaves->median, -1.0, size == 1 ? 0.12 : 0.05) << size << ", " << angle_rad;
    }
  }
}

TEST(Penumbra, QuantisedEdgesLieInTheMiddleOfTheirPlateaus) {
  const Image surface = floor_from_above(256, 32, 0.01);
  const Image reference = lit_floor(surface, edge(1.28, 0.16, 0.0, 1.0));
  for (const int taps : {4, 8, 16, 17}) {
    const Image test = lit_floor(
        surface, [&](double x, double) { return std::floor(box_ramp(x - 1.28, 1.0) * taps + 0.5) / taps; });
    EXPECT_NEAR(measure(test, reference).offset_world->median, 0.0, 0.005) << taps;
  }
}

// Light between two shadows, 20 apart, each with a penumbra of `width`: of 40 it peaks at .75.
testing::FloorField overlap(double width) {
  return
      [=](double x, double) { return x < 110.0 ? box_ramp(x - 100.0, width) : box_ramp(120.0 - x, width); };
}

TEST(Penumbra, AnOverlapTellsItsWidthByTheStretchThatThereIs) {
  const Image surface = floor_from_above(220, 40, 1.0);
  const Image reference = lit_floor(surface, overlap(40.0));
  const PenumbraError same = measure(reference, reference);
  EXPECT_GT(count(same, ProfileOutcome::accepted), 5u);
  EXPECT_EQ(same.partial, count(same, ProfileOutcome::accepted));
  EXPECT_EQ(same.width_octaves->rmse, 0.0);
  size_t overlapping = 0;
  for (const PenumbraProfile& profile : same.profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    EXPECT_NEAR(profile.reference_width_world, 40.0, 2.0);
    overlapping += profile.overlaps ? 1 : 0;
  }
  EXPECT_GT(overlapping, 5u);
  for (const double factor : {0.7, 1.4}) {
    const PenumbraError error = measure(lit_floor(surface, overlap(40.0 * factor)), reference);
    ASSERT_TRUE(error.width_octaves) << factor;
    EXPECT_NEAR(error.width_octaves->median, std::log2(factor), 0.1) << factor;
    EXPECT_NEAR(error.offset_world->median, 0.0, 1.0) << factor;
  }
}

TEST(Penumbra, AnOverlapOfLittleLightTellsNothing) {
  const Image reference = lit_floor(floor_from_above(220, 40, 1.0), [](double x, double) {
    return x < 110.0 ? 0.65 * box_ramp(x - 100.0, 40.0) + 0.3 : 0.65 * box_ramp(120.0 - x, 40.0) + 0.3;
  });
  const Image flat = lit_floor(floor_from_above(220, 40, 1.0), [](double, double) { return 0.6; });
  EXPECT_FALSE(measure(flat, reference).width_octaves);
}

TEST(Penumbra, AShadowWithoutUmbraTellsItsWidthByItsFlanks) {
  // A blocker of .4 of the light: R falls to .6 over .4 of the penumbra and rises again.
  const Image surface = floor_from_above(300, 40, 1.0);
  const auto faint = [](double width) {
    return [=](double x, double) {
      return 1.0 - std::max(0.0, box_ramp(150.0 + 10.0 - x, width) + box_ramp(x - 150.0 + 10.0, width) - 1.0);
    };
  };
  const Image reference = lit_floor(surface, faint(50.0));
  const PenumbraError same = measure(reference, reference);
  EXPECT_GT(count(same, ProfileOutcome::accepted), 5u);
  for (const PenumbraProfile& profile : same.profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    EXPECT_NEAR(profile.reference_width_world, 50.0, 3.0);
    EXPECT_TRUE(profile.is_partial && !profile.has_ridge);
  }
  for (const double factor : {0.7, 1.3}) {
    const PenumbraError error = measure(lit_floor(surface, faint(50.0 * factor)), reference);
    ASSERT_TRUE(error.width_octaves) << factor;
    EXPECT_NEAR(error.width_octaves->median, std::log2(factor), 0.1) << factor;
  }
}

TEST(Penumbra, ASurfaceThatEndsInThePenumbraIsADiscontinuity) {
  // Steps of height 5 at x = 55 and 64 leave .225 of a penumbra from 40 to 80.
  Image surface = floor_from_above(128, 32, 1.0);
  for (size_t i = 0; i < surface.pixel_count(); ++i) {
    if (i % 128 >= 55 && i % 128 < 64) continue;
    surface.plane("position.y")[i] = 5.0f;
    surface.plane("primitive_id")[i] = 1.0f;
  }
  const Image reference = lit_floor(surface, edge(60.0, 16.0, 0.0, 40.0));
  const PenumbraError error = measure(reference, reference);
  EXPECT_GT(count(error, ProfileOutcome::discontinuity), 2u);
  EXPECT_EQ(count(error, ProfileOutcome::accepted), 0u);
}

TEST(Penumbra, ASurfaceThatEndsInThePenumbraTellsItsWidthByWhatIsLeft) {
  Image surface = floor_from_above(128, 32, 1.0);
  for (size_t i = 0; i < surface.pixel_count(); ++i) {
    if (i % 128 < 68) continue;
    surface.plane("position.y")[i] = 5.0f;
    surface.plane("primitive_id")[i] = 1.0f;
  }
  const Image reference = lit_floor(surface, edge(60.0, 16.0, 0.0, 40.0));
  const PenumbraError error = measure(lit_floor(surface, edge(60.0, 16.0, 0.0, 60.0)), reference);
  EXPECT_GT(error.partial, 2u);
  EXPECT_NEAR(error.width_octaves->median, std::log2(1.5), 0.06);
}

TEST(Penumbra, ATessellatedFloorIsOneSurface) {
  Image surface = floor_from_above(128, 32, 1.0);
  for (size_t i = 0; i < surface.pixel_count(); ++i)
    surface.plane("primitive_id")[i] = static_cast<float>(i % 7);
  const Image reference = lit_floor(surface, edge(60.0, 16.0, 0.0, 40.0));
  EXPECT_GT(count(measure(reference, reference), ProfileOutcome::accepted), 2u);
}

TEST(Penumbra, CountsWhatItCannotMeasure) {
  const Image surface = floor_from_above(128, 32, 1.0);
  const Image narrow = lit_floor(surface, edge(64.3, 16.0, 0.0, 2.0));
  EXPECT_GT(count(measure(narrow, narrow), ProfileOutcome::too_narrow), 2u);

  const Image thin = lit_floor(
      surface, [](double x, double) { return 0.7 + 0.3 * std::min(1.0, std::abs(x - 64.0) / 20.0); });
  EXPECT_GT(count(measure(thin, thin), ProfileOutcome::no_ridge), 2u);

  const Image reference = lit_floor(surface, edge(64.0, 16.0, 0.0, 20.0));
  const Image none = lit_floor(surface, [](double, double) { return 1.0; });
  const PenumbraError lost = measure(none, reference);
  EXPECT_GT(count(lost, ProfileOutcome::test_unreached), 2u);
  EXPECT_FALSE(lost.width_octaves);
  size_t all = 0;
  for (const size_t n : lost.outcomes) all += n;
  EXPECT_EQ(all, lost.profiles.size());
}

TEST(Penumbra, WithoutAShadowNothingIsMeasured) {
  const Image lit = lit_floor(floor_from_above(64, 64, 1.0), [](double, double) { return 1.0; });
  const PenumbraError error = measure(lit, lit);
  EXPECT_TRUE(error.profiles.empty());
  EXPECT_FALSE(error.width_octaves || error.offset_world);
}

TEST(Penumbra, RejectsANaNWithItsPixel) {
  const Image reference = lit_floor(floor_from_above(64, 64, 1.0), [](double, double) { return 1.0; });
  Image test = reference;
  test.plane("visibility")[65] = std::nanf("");
  try {
    measure(test, reference);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("nan at pixel (1, 1)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace umbrameter

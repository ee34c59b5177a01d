// SPDX-License-Identifier: Apache-2.0
// Without these a still picture could flicker, or a flickering one pass for still.
#include "metrics/temporal/temporal.h"

#include "core/error.h"
#include "core/spaces.h"
#include "tests/unit/metrics/synthetic.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::add_surface_planes;
using testing::box_ramp;
using testing::everywhere;
using testing::floor_from_above;
using testing::FloorField;
using testing::lit_floor;

constexpr int kWidth = 160, kHeight = 96;

// The floor y = 0 through a camera 4 above (x, 0), looking straight down.
struct View {
  Image surface{kWidth, kHeight};
  glm::dmat4 clip_from_world{1.0};

  explicit View(double x_world) {
    add_surface_planes(surface);
    const double aspect = static_cast<double>(kWidth) / kHeight, fov = 0.8, half = 4.0 * std::tan(0.5 * fov);
    clip_from_world = clip_from_view(fov, aspect, 0.1) *
                      view_from_world({x_world, 4.0, 0.0}, {x_world, 0.0, 0.0}, {0.0, 0.0, -1.0});
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const size_t i = static_cast<size_t>(y * kWidth + x);
        surface.plane("position.x")[i] =
            static_cast<float>(x_world + (2.0 * (x + 0.5) / kWidth - 1.0) * half * aspect);
        surface.plane("position.z")[i] = static_cast<float>((2.0 * (y + 0.5) / kHeight - 1.0) * half);
      }
    }
  }
};

double soft(double x, double) {
  return box_ramp(x, 0.8);
}

// Frames from `steps` world units apart; the test's field may know the frame.
struct Sequence {
  std::vector<Image> tests, references;
  std::vector<std::vector<uint8_t>> masks;
  std::vector<SequenceFrame> frames;

  template <class Field>
  Sequence(double step, const Field& field, int samples = 0) {
    for (int k = 0; k < 4; ++k) {
      const View view(step * k);
      tests.push_back(lit_floor(view.surface, [&](double x, double z) { return field(k, x, z); }));
      references.push_back(lit_floor(view.surface, soft, samples, static_cast<uint64_t>(k + 1)));
      masks.push_back(everywhere(tests.back()));
      frames.push_back({nullptr, nullptr, {}, view.clip_from_world});
    }
    for (size_t k = 0; k < frames.size(); ++k) {
      frames[k].test = &tests[k];
      frames[k].reference = &references[k];
      frames[k].mask = masks[k];
    }
  }
};

constexpr double kStep = 0.0733;  // 2.1 px

TEST(Flicker, AFieldFixedToTheWorldHasNone) {
  const Sequence sequence(kStep, [](int, double x, double z) { return soft(x, z); });
  const Flicker flicker = measure_flicker(sequence.frames);
  EXPECT_GT(flicker.points, 3000u);
  EXPECT_GT(flicker.rejected, 50u);  // left the picture
  EXPECT_LT(*flicker.test, 1e-3);
  EXPECT_NEAR(*flicker.excess, 0.0, 1e-6);
}

TEST(Flicker, MeasuresALevelThatChangesByFrame) {
  // 0, .1, 0, .1: the variance over four frames is .01 / 3.
  const Sequence sequence(kStep, [](int k, double, double) { return 0.5 + 0.1 * (k % 2); });
  const Flicker flicker = measure_flicker(sequence.frames);
  EXPECT_NEAR(*flicker.test, std::sqrt(0.01 / 3.0), 1e-6);
  EXPECT_NEAR(*flicker.excess, *flicker.test, 1e-4);
}

TEST(Flicker, OfTheReferenceIsFreeOfItsNoise) {
  const Sequence sequence(
      kStep, [](int, double x, double z) { return soft(x, z); }, 64);
  // A penumbra of 64 samples has a standard deviation of up to .06.
  EXPECT_LT(std::abs(*measure_flicker(sequence.frames).reference), 0.004);
}

TEST(Flicker, PointsBehindAnotherSurfaceAreRejected) {
  Sequence sequence(kStep, [](int, double x, double z) { return soft(x, z); });
  const size_t before = measure_flicker(sequence.frames).points;
  for (int y = 0; y < kHeight; ++y) {  // in the last frame a wall hides the right half
    for (int x = kWidth / 2; x < kWidth; ++x) {
      sequence.references[3].plane("position.y")[static_cast<size_t>(y * kWidth + x)] = 1.0f;
    }
  }
  const Flicker hidden = measure_flicker(sequence.frames);
  EXPECT_LT(hidden.points, 6 * before / 10);
  EXPECT_LT(*hidden.test, 1e-3);
}

TEST(Flicker, SwappedFramesOfTheReferenceAreDetected) {
  Sequence sequence(kStep, [](int, double x, double z) { return soft(x, z); });
  std::swap(sequence.frames[0].clip_from_world, sequence.frames[3].clip_from_world);
  EXPECT_LT(measure_flicker(sequence.frames).points, 100u);
}

TEST(Popping, AConstantErrorHasNoneAndAChangeIsMeasured) {
  const Sequence constant(0.0, [](int, double x, double z) { return 0.9 * soft(x, z); });
  EXPECT_NEAR(*measure_popping(constant.frames).rms, 0.0, 1e-7);
  const Sequence jumping(0.0, [](int k, double x, double z) { return 0.9 * soft(x, z) + 0.05 * (k % 2); });
  const Popping popping = measure_popping(jumping.frames);
  EXPECT_NEAR(*popping.rms, 0.05, 1e-6);
  EXPECT_EQ(popping.pixels, 3u * kWidth * kHeight);
}

TEST(Popping, IsFreeOfTheReferencesNoise) {
  const Sequence still(
      0.0, [](int, double x, double z) { return soft(x, z); }, 64);
  EXPECT_LT(std::abs(*measure_popping(still.frames).rms), 0.01);
}

TEST(SeedNoise, IsTheSpreadOverSeeds) {
  const View view(0.0);
  const auto level = [&](double v) { return lit_floor(view.surface, [v](double, double) { return v; }); };
  const Image a = level(0.4), b = level(0.6);
  const Image* tests[] = {&a, &b};
  // Variance of two values d apart is d^2 / 2.
  EXPECT_NEAR(*measure_seed_noise(tests, everywhere(a)), 0.2 / std::sqrt(2.0), 1e-6);
  const Image* same[] = {&a, &a};
  EXPECT_EQ(*measure_seed_noise(same, everywhere(a)), 0.0);
  EXPECT_FALSE(measure_seed_noise(tests, std::vector<uint8_t>(a.pixel_count(), 0)));
}

TEST(Temporal, NothingScoredIsNotApplicableAndOneFrameAnError) {
  Sequence sequence(kStep, [](int, double x, double z) { return soft(x, z); });
  for (auto& mask : sequence.masks) std::fill(mask.begin(), mask.end(), 0);
  EXPECT_FALSE(measure_flicker(sequence.frames).test);
  EXPECT_FALSE(measure_popping(sequence.frames).rms);
  EXPECT_THROW(measure_flicker(std::span(sequence.frames).first(1)), Error);
  EXPECT_THROW(measure_popping(std::span(sequence.frames).first(1)), Error);
}

TEST(Temporal, ANanNamesItsPixel) {
  Sequence sequence(kStep, [](int, double x, double z) { return soft(x, z); });
  sequence.tests[2].plane("visibility")[3 * kWidth + 4] = std::nanf("");
  try {
    measure_flicker(sequence.frames);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("(4, 3)"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace umbrameter

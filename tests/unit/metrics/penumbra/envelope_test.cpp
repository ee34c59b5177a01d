// SPDX-License-Identifier: Apache-2.0
// Without these, a benign penumbra could be called a fault, or a leak three pixels wide pass as none.
#include "metrics/penumbra/envelope.h"

#include "core/error.h"
#include "metrics/image/nearest_feature.h"
#include "tests/unit/metrics/synthetic.h"

#include <gtest/gtest.h>

#include <oneapi/tbb/global_control.h>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::everywhere;
using testing::floor_from_above;
using testing::lit_floor;

TEST(NearestFeature, EqualsTheExhaustiveSearch) {
  std::mt19937 random(4);
  const int width = 37, height = 23;
  for (const int features : {1, 2, 9, 300}) {
    std::vector<uint8_t> is_feature(static_cast<size_t>(width * height), 0);
    for (int k = 0; k < features; ++k) is_feature[random() % is_feature.size()] = 1;
    const std::vector<int32_t> nearest = nearest_feature(is_feature, width, height);
    const auto distance = [&](int i, int j) {
      const int dx = i % width - j % width, dy = i / width - j / width;
      return dx * dx + dy * dy;
    };
    for (int i = 0; i < width * height; ++i) {
      int least = 1 << 30;
      for (int j = 0; j < width * height; ++j) {
        if (is_feature[static_cast<size_t>(j)] != 0) least = std::min(least, distance(i, j));
      }
      ASSERT_EQ(is_feature[static_cast<size_t>(nearest[static_cast<size_t>(i)])], 1);
      ASSERT_EQ(distance(i, nearest[static_cast<size_t>(i)]), least) << "pixel " << i << ", " << features;
    }
  }
}

TEST(NearestFeature, IsNoneWithoutFeatures) {
  for (const int32_t index : nearest_feature(std::vector<uint8_t>(12, 0), 4, 3)) EXPECT_EQ(index, -1);
}

// A plate's shadow: penumbra `width` around x = 128, dark below.
testing::FloorField half_plane(double width) {
  return [width](double x, double) { return box_ramp(x - 128.0, width); };
}

Envelope measure(const Image& test, const Image& reference) {
  const PenumbraError penumbra = measure_penumbra(test, reference, everywhere(reference));
  return measure_envelope(test, reference, everywhere(reference), penumbra.profiles);
}

TEST(Envelope, IsZeroForTheTruth) {
  const Image reference = lit_floor(floor_from_above(256, 64, 1.0), half_plane(40.0));
  const Envelope envelope = measure(reference, reference);
  EXPECT_EQ(envelope.dark_pixels + envelope.bright_pixels, 0u);
  EXPECT_EQ(envelope.mean_dark->value, 0.0);
  EXPECT_EQ(envelope.mean_dark->high, 0.0);
}

TEST(Envelope, ExcusesAPenumbraTenPercentWideAndAShiftOfAPixel) {
  const Image surface = floor_from_above(256, 64, 1.0);
  const Image reference = lit_floor(surface, half_plane(40.0));
  const Envelope wider = measure(lit_floor(surface, half_plane(44.0)), reference);
  EXPECT_EQ(wider.dark_pixels + wider.bright_pixels, 0u);
  const Image shifted = lit_floor(surface, [](double x, double) { return box_ramp(x - 129.0, 40.0); });
  EXPECT_EQ(measure(shifted, reference).dark_pixels, 0u);
}

TEST(Envelope, ExcusesTheNoiseOfTheReference) {
  const Image surface = floor_from_above(256, 64, 1.0);
  const Envelope envelope =
      measure(lit_floor(surface, half_plane(40.0)), lit_floor(surface, half_plane(40.0), 256));
  EXPECT_LT(envelope.mean_dark->value + envelope.mean_bright->value, 1e-5);
}

TEST(Envelope, ReportsAWidthTwiceTooLarge) {
  const Image surface = floor_from_above(256, 64, 1.0);
  const Envelope envelope =
      measure(lit_floor(surface, half_plane(80.0)), lit_floor(surface, half_plane(40.0)));
  EXPECT_GT(envelope.dark_pixels, 100u);
  EXPECT_GT(envelope.bright_pixels, 100u);
}

TEST(Envelope, FindsALeakSlitAndSaysHowBright) {
  const Image reference = lit_floor(floor_from_above(256, 64, 1.0), half_plane(20.0));
  Image test = reference;
  size_t slit = 0;
  for (int y = 10; y < 50; ++y) {
    for (int x = 60; x < 63; ++x, ++slit) test.plane("visibility")[static_cast<size_t>(y * 256 + x)] = 1.0f;
  }
  const Envelope envelope = measure(test, reference);
  EXPECT_EQ(envelope.bright_pixels, slit);
  EXPECT_EQ(envelope.dark_pixels, 0u);
  EXPECT_FLOAT_EQ(envelope.bright[20 * 256 + 61], 1.0f - 0.0f - 0.02f);
  EXPECT_NEAR(envelope.mean_bright->value, 0.98 * static_cast<double>(slit) / (256 * 64), 1e-8);
  EXPECT_GT(envelope.mean_bright->high, envelope.mean_bright->value);
}

TEST(Envelope, TheRadiusIsOnePixelAndAShareOfTheNearestWidth) {
  // Widths 40 px: r = 1 + .15 * 40 = 7 px, so a fully lit pixel is excused up to 7 px from full light.
  Image reference = floor_from_above(256, 32, 1.0);
  for (const char* name : {"visibility", "visibility_se"}) reference.add_plane(name, 0.0f);
  for (size_t i = 0; i < reference.pixel_count(); ++i)
    reference.plane("visibility")[i] = i % 256 >= 128 ? 1.0f : 0.0f;
  const Image lit = [&] {
    Image image = reference;
    for (float& v : image.plane("visibility")) v = 1.0f;
    return image;
  }();
  PenumbraProfile profile;
  profile.x = 128;
  profile.y = 16;
  profile.reference_width_px = 40.0;
  const Envelope envelope = measure_envelope(lit, reference, everywhere(reference), std::vector{profile});
  EXPECT_EQ(envelope.bright[16 * 256 + 128 - 7], 0.0f);
  EXPECT_FLOAT_EQ(envelope.bright[16 * 256 + 128 - 8], 0.98f);
  EXPECT_EQ(envelope.nearest_profile[0], 0);
}

TEST(Envelope, MaskedPixelsNeitherCountNorExcuse) {
  const Image reference =
      lit_floor(floor_from_above(128, 32, 1.0), [](double x, double) { return x > 64.0 ? 0.0 : 1.0; });
  Image test = reference;
  for (float& v : test.plane("visibility")) v = 0.0f;
  std::vector<uint8_t> mask = everywhere(reference);
  for (size_t i = 0; i < mask.size(); ++i) mask[i] = i % 128 < 64 ? 1 : 0;
  const Envelope envelope = measure_envelope(test, reference, mask, {});
  EXPECT_EQ(envelope.scored_pixels, 64u * 32u);
  EXPECT_EQ(envelope.dark_pixels, 64u * 32u);  // even beside the masked dark half
}

TEST(Envelope, NothingScoredIsNotApplicable) {
  const Image reference = lit_floor(floor_from_above(64, 32, 1.0), half_plane(4.0));
  const Envelope envelope =
      measure_envelope(reference, reference, std::vector<uint8_t>(reference.pixel_count(), 0), {});
  EXPECT_FALSE(envelope.mean_dark || envelope.mean_bright);
}

TEST(Envelope, SwappingTheOperandsSwapsDarkAndBright) {
  const Image surface = floor_from_above(256, 64, 1.0);
  const Image a = lit_floor(surface, [](double, double) { return 1.0; });
  Image b = a;
  b.plane("visibility")[5000] = 0.25f;
  const Envelope forth = measure(b, a), back = measure(a, b);
  EXPECT_EQ(forth.dark_pixels, 1u);
  EXPECT_EQ(forth.bright_pixels, 0u);
  EXPECT_FLOAT_EQ(forth.dark[5000], 0.73f);
  EXPECT_EQ(back.dark_pixels, 0u);
  EXPECT_EQ(back.bright_pixels, 0u);  // the neighbours are as bright
}

TEST(Envelope, SameBitsWithAnyThreadCount) {
  const Image surface = floor_from_above(256, 64, 1.0);
  const Image reference = lit_floor(surface, half_plane(30.0), 64);
  const Image test = lit_floor(surface, half_plane(90.0), 16, 7);
  const Envelope many = measure(test, reference);
  oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const Envelope single = measure(test, reference);
  EXPECT_EQ(many.dark, single.dark);
  EXPECT_EQ(many.mean_bright->value, single.mean_bright->value);
  EXPECT_EQ(many.mean_bright->low, single.mean_bright->low);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a metric could depend on the scene's unit or on which picture came first, or read past a smaller one.
#include "metrics/causes/causes.h"
#include "metrics/error/similarity.h"
#include "metrics/faults/moire.h"

#include "core/error.h"
#include "tests/unit/metrics/fault_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::classify_floor;
using testing::everywhere;
using testing::fault_floor;

Image half_plane(double width, double shift = 0.0) {
  return fault_floor([=](double x, double) { return box_ramp(x - 1.0 - shift, width); });
}

Image in_other_unit(Image image, float factor) {
  for (const char* name : {"position.x", "position.y", "position.z", "blocker_distance_min"}) {
    for (float& value : image.plane(name)) value *= factor;
  }
  return image;
}

TEST(Properties, TheWorldsUnitChangesLengthsAlone) {
  const Image reference = half_plane(0.3), test = half_plane(0.36, 0.02);
  const auto measure = [&](float factor) {
    const Image truth = in_other_unit(reference, factor);
    return measure_penumbra(in_other_unit(test, factor), truth, everywhere(truth));
  };
  const PenumbraError one = measure(1.0f);
  ASSERT_GT(one.width_octaves->count, 5u);
  for (const float factor : {1e-3f, 1e3f}) {
    const PenumbraError other = measure(factor);
    EXPECT_EQ(other.outcomes, one.outcomes);
    EXPECT_NEAR(other.width_octaves->median, one.width_octaves->median, 1e-4);
    EXPECT_NEAR(other.offset_world->median / factor, one.offset_world->median, 1e-5);
    EXPECT_EQ(classify_floor(in_other_unit(test, factor), in_other_unit(reference, factor)).classes,
              classify_floor(test, reference).classes);
  }
}

TEST(Properties, SwappedOperandsChangeTheSignOfWidthAndOffset) {
  const Image a = half_plane(0.3), b = half_plane(0.36, 0.02);
  const PenumbraError forth = measure_penumbra(b, a, everywhere(a)),
                      back = measure_penumbra(a, b, everywhere(a));
  EXPECT_GT(forth.width_octaves->median, 0.2);
  EXPECT_GT(forth.offset_world->median, 0.01);
  EXPECT_NEAR(back.width_octaves->median, -forth.width_octaves->median, 1e-3);
  EXPECT_NEAR(back.offset_world->median, -forth.offset_world->median, 1e-3);
}

TEST(Properties, PsnrAndSsimAreSymmetric) {
  const Image a = half_plane(0.3), b = half_plane(0.5);
  EXPECT_EQ(*measure_psnr_db(a, b, "visibility"), *measure_psnr_db(b, a, "visibility"));
  EXPECT_NEAR(*measure_ssim(a, b, "visibility"), *measure_ssim(b, a, "visibility"), 1e-6);
}

TEST(Properties, AnotherSizeOfPictureOrMaskIsAnError) {
  const Image reference = half_plane(0.3), small = testing::floor_from_above(64, 64, 0.01);
  const std::vector<uint8_t> mask = everywhere(reference), small_mask = everywhere(small);
  const PenumbraError penumbra = measure_penumbra(reference, reference, mask);
  const Envelope envelope = measure_envelope(reference, reference, mask, penumbra.profiles);
  const Faults faults = classify_faults(reference, reference, mask, penumbra.profiles, envelope);
  const auto rejects = [&](const auto& metric) {
    EXPECT_THROW(metric(small, mask), Error);
    EXPECT_THROW(metric(reference, small_mask), Error);
  };
  rejects([&](const Image& test, const auto& m) { measure_penumbra(test, reference, m); });
  rejects([&](const Image& test, const auto& m) { measure_envelope(test, reference, m, {}); });
  rejects([&](const Image& test, const auto& m) { classify_faults(test, reference, m, {}, envelope); });
  rejects([&](const Image& test, const auto& m) { measure_causes(test, reference, m, {}); });
  rejects([&](const Image& test, const auto& m) { measure_moire(test, reference, m, faults); });
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, errors of real pictures would end in the wrong class: a coarse map called a leak, moire an extra
// shadow, an eaten contact shadow a lost object.
#include "tests/unit/metrics/fault_scene.h"

#include "metrics/image/components.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::add_map;
using testing::box_ramp;
using testing::classify_floor;
using testing::fault_floor;
using testing::floor_at;
using testing::for_floor_rectangle;
using testing::kFloorHeight;
using testing::kFloorPixel;
using testing::kFloorWidth;

Image half_plane(double width = 0.2) {
  return fault_floor([width](double x, double) { return box_ramp(x - 1.0, width); });
}

size_t pixels_but(const Faults& faults, FaultClass but) {
  size_t pixels = 0;
  for (const FaultClass fault : faults.classes)
    pixels += fault != but && fault != FaultClass::explained ? 1 : 0;
  return pixels;
}

double sum_of_shares(const Faults& faults) {
  double sum = 0.0;
  for (const FaultShare& share : faults.by_class) sum += share.mean_abs_error;
  return sum;
}

TEST(FaultClasses, AFaintPenumbraThatNeverReachesHalfIsAPenumbra) {
  // A blocker of a fifth of the light: R falls to .8 and back over 1 m; the test draws it as a hard .8.
  const auto faint = [](double x, double) { return 1.0 - 0.2 * box_ramp(0.4 - std::abs(x - 1.2), 0.4); };
  const Image reference = fault_floor(faint);
  const Image test = fault_floor([](double x, double) { return std::abs(x - 1.2) < 0.55 ? 0.8 : 1.0; });
  const Faults faults = classify_floor(test, reference);
  EXPECT_GT(faults.of(FaultClass::penumbra).pixels, 1000u);
  EXPECT_EQ(pixels_but(faults, FaultClass::penumbra), 0u);
}

TEST(FaultClasses, WhereTwoPenumbraeMeetItIsOverlap) {
  // Two sheets with a gap narrower than their penumbrae: light between them never gets full.
  const auto gap = [](double width) {
    return [width](double x, double) {
      return std::max(0.0, box_ramp(x - 0.9, width) + box_ramp(1.2 - x, width) - 1.0);
    };
  };
  const Faults faults = classify_floor(fault_floor(gap(0.1)), fault_floor(gap(0.4)));
  EXPECT_GT(faults.of(FaultClass::overlap).pixels, 2000u);
  // Bands among cells without a ridge cannot tell overlap from softness.
  EXPECT_EQ(pixels_but(faults, FaultClass::overlap), faults.of(FaultClass::penumbra).pixels);
  // Far apart the same penumbrae do not overlap.
  EXPECT_EQ(classify_floor(half_plane(0.1), half_plane(0.4)).of(FaultClass::overlap).pixels, 0u);
}

TEST(FaultClasses, AnEdgeAsCoarseAsTheMapIsItsResolution) {
  // A sharp slanted edge; the test's follows texels of 6 px.
  const auto edge = [](double x, double z) { return x - 1.0 - 0.3 * z > 0.0 ? 1.0 : 0.0; };
  const Image reference = fault_floor(edge);
  const auto coarse = [&](double x, double z) {
    const double texel = 6.0 * kFloorPixel;
    return edge((std::floor(x / texel) + 0.5) * texel, (std::floor(z / texel) + 0.5) * texel);
  };
  Image test = fault_floor(coarse);
  add_map(test, 6.0);
  const Faults faults = classify_floor(test, reference);
  EXPECT_GT(faults.of(FaultClass::resolution).pixels, 60u);
  EXPECT_EQ(pixels_but(faults, FaultClass::resolution), 0u);
  // The same steps from a fine map are not its resolution.
  add_map(test, 0.5);
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::resolution).pixels, 0u);
}

TEST(FaultClasses, MoireThatRunsIntoATrueShadowIsAcneNotAnExtraShadow) {
  const Image reference = half_plane();
  Image test = reference;
  // A net of stripes whose crossings join everything, the shadow included.
  for_floor_rectangle(100, 0, kFloorWidth, kFloorHeight, [&](size_t i) {
    const size_t x = i % kFloorWidth, y = i / kFloorWidth;
    if (x % 8 < 4 || y % 16 < 4) test.plane("visibility")[i] = 0.0f;
  });
  const Faults faults = classify_floor(test, reference);
  EXPECT_EQ(faults.of(FaultClass::extra_shadow).pixels, 0u);
  EXPECT_GT(faults.of(FaultClass::acne).mean_abs_error, 0.9 * *faults.mean_abs_error);
}

TEST(FaultClasses, AFacetDarkFromRimToRimShadowsItself) {
  Image reference = half_plane();
  // The rectangle is the top of a box: another surface, a metre higher.
  const size_t facet = for_floor_rectangle(150, 30, 210, 90, [&](size_t i) {
    reference.plane("position.y")[i] = 1.0f;
    reference.plane("primitive_id")[i] = 7.0f;
  });
  Image test = reference;
  for_floor_rectangle(150, 30, 210, 90, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::acne).pixels, facet);
  // Half of it only: something stands between, a shadow's rim crosses the facet.
  test = reference;
  const size_t half =
      for_floor_rectangle(150, 30, 180, 90, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::extra_shadow).pixels, half);
}

TEST(FaultClasses, AContactShadowThatIsGoneIsPeterPanning) {
  Image reference = half_plane();
  const size_t shadow = for_floor_rectangle(170, 40, 180, 60, [&](size_t i) {
    reference.plane("visibility")[i] = 0.0f;
    reference.plane("blocker_distance_min")[i] = 0.02f;
    reference.plane("blocker_layers")[i] = 1.0f;
  });
  const Faults contact = classify_floor(half_plane(), reference);
  EXPECT_EQ(contact.of(FaultClass::peter_panning).pixels, shadow);
  for_floor_rectangle(170, 40, 180, 60, [&](size_t i) { reference.plane("blocker_distance_min")[i] = 3.0f; });
  EXPECT_EQ(classify_floor(half_plane(), reference).of(FaultClass::lost_shadow).pixels, shadow);
}

TEST(FaultClasses, AShadowWhoseShadeIsFoundAroundItIsBlurredNotLost) {
  // Four posts' shadows, 6 x 6 px, without a penumbra, and the same shade over 24 x 24 px each.
  const auto posts = [](Image& image, int half_px, float visibility) {
    for (int k = 0; k < 4; ++k) {
      const int x = 150 + 25 * k;
      for_floor_rectangle(x - half_px, 64 - half_px, x + half_px, 64 + half_px, [&](size_t i) {
        image.plane("visibility")[i] = visibility;
        image.plane("blocker_distance_min")[i] = 0.02f;
        image.plane("blocker_layers")[i] = 1.0f;
      });
    }
  };
  Image reference = half_plane(), test = half_plane();
  posts(reference, 3, 0.0f);
  posts(test, 12, 1.0f - 36.0f / 576.0f);
  const Faults blurred = classify_floor(test, reference);
  EXPECT_EQ(blurred.of(FaultClass::lost_shadow).pixels, 0u);
  EXPECT_EQ(blurred.of(FaultClass::peter_panning).pixels, 0u);
  EXPECT_EQ(blurred.of(FaultClass::acne).pixels, 0u);  // the shade around, almost gone on the true edge
  EXPECT_GE(blurred.of(FaultClass::penumbra_too_wide).pixels, 4u * 36u);
  // The same shade a tenth as strong is not the shadow's.
  test = half_plane();
  posts(test, 12, 1.0f - 3.6f / 576.0f);
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::peter_panning).pixels, 4u * 36u);
}

TEST(FaultClasses, TheTipWithoutUmbraOfALostShadowIsLostWithIt) {
  Image reference = fault_floor([](double, double) { return 1.0; });
  const auto shade = [](Image& image, int x0, int x1, float visibility) {
    return for_floor_rectangle(x0, 56, x1, 68, [&](size_t i) {
      image.plane("visibility")[i] = visibility;
      image.plane("blocker_distance_min")[i] = 3.0f;
      image.plane("blocker_layers")[i] = 1.0f;
    });
  };
  const Image lit = reference;
  const size_t core = shade(reference, 20, 36, 0.1f);
  const size_t tip = shade(reference, 36, 200, 0.6f);
  EXPECT_EQ(classify_floor(lit, reference).of(FaultClass::lost_shadow).pixels, core + tip);
  Image test = lit;
  shade(test, 36, 200, 0.7f);  // too light, but there
  EXPECT_LE(classify_floor(test, reference).of(FaultClass::lost_shadow).pixels, core);
}

TEST(FaultClasses, LightWhereTheReceiverHidesTheLightIsTheTerminator) {
  Image reference = half_plane();
  for_floor_rectangle(180, 20, 240, 100, [&](size_t i) { reference.plane("visibility")[i] = 0.6f; });
  const Image test = half_plane();
  const Faults faults = classify_floor(test, reference);  // no blockers there
  EXPECT_GT(faults.of(FaultClass::terminator).pixels, 4000u);
  EXPECT_EQ(pixels_but(faults, FaultClass::terminator), 0u);
}

TEST(FaultClasses, AMixedComponentIsDivided) {
  Image reference = half_plane();
  for_floor_rectangle(20, 20, 60, 100, [&](size_t i) { reference.plane("blocker_distance_min")[i] = 0.02f; });
  Image test = reference;
  // A hole of which one half is in contact and the other is not.
  const size_t half =
      for_floor_rectangle(40, 40, 60, 80, [&](size_t i) { test.plane("visibility")[i] = 1.0f; });
  for_floor_rectangle(60, 40, 80, 80, [&](size_t i) { test.plane("visibility")[i] = 1.0f; });
  const Faults faults = classify_floor(test, reference);
  EXPECT_EQ(faults.of(FaultClass::peter_panning).pixels, half);
  EXPECT_EQ(faults.of(FaultClass::geometric_leak).pixels, half);
  EXPECT_EQ(faults.of(FaultClass::geometric_leak).components, 1u);
}

TEST(FaultClasses, OneLayerOfASolidBlockerDoesNotBleed) {
  const Image reference = half_plane();
  Image test = reference;
  const size_t dim =
      for_floor_rectangle(20, 30, 50, 90, [&](size_t i) { test.plane("visibility")[i] = 0.15f; });
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::geometric_leak).pixels, dim);
}

TEST(FaultClasses, SharesAreTheTotalToTheLastBit) {
  const Image reference = half_plane();
  Image test = half_plane(0.5);
  add_map(test, 3.0);
  std::mt19937 random(5);
  for (int k = 0; k < 4000; ++k) {
    test.plane("visibility")[random() % test.pixel_count()] = static_cast<float>(random() % 997) / 997.0f;
  }
  const Faults faults = classify_floor(test, reference);
  EXPECT_EQ(sum_of_shares(faults), *faults.mean_abs_error);
  const std::span<const float> v = test.plane("visibility"), r = reference.plane("visibility");
  double sum = 0.0;
  for (size_t i = 0; i < v.size(); ++i) sum += std::abs(static_cast<double>(v[i]) - r[i]);
  EXPECT_NEAR(*faults.mean_abs_error, sum / static_cast<double>(v.size()), 1e-13);
}

TEST(FaultClasses, SwappedOperandsAreDetected) {
  const Image reference = half_plane();
  Image test = reference;
  for_floor_rectangle(160, 40, 190, 80, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  EXPECT_GT(classify_floor(test, reference).of(FaultClass::extra_shadow).pixels, 0u);
  const Faults faults = classify_floor(reference, test);
  EXPECT_EQ(faults.of(FaultClass::extra_shadow).pixels, 0u);
  EXPECT_GT(faults.of(FaultClass::lost_shadow).pixels, 0u);
}

TEST(LabelComponents, KeepsDifferentValuesApart) {
  const std::vector<uint8_t> mask = {1, 1, 2, 2,  //
                                     0, 2, 1, 2,  //
                                     1, 0, 0, 1};
  const Components components = label_components(mask, 4, 3);
  EXPECT_EQ(components.count, 3u);
  EXPECT_EQ(components.label[0], components.label[6]);
  EXPECT_EQ(components.label[2], components.label[5]);
  EXPECT_EQ(components.label[6], components.label[11]);
  EXPECT_NE(components.label[8], components.label[0]);
}

TEST(LabelComponents, JoinsAcrossStripsInReadingOrder) {
  // A serpent through 200 rows, and pixels beside it.
  constexpr int kSide = 200;
  std::vector<uint8_t> mask(kSide * kSide, 0);
  for (int y = 0; y < kSide; ++y) mask[static_cast<size_t>(y * kSide + 20 + y % 2)] = 1;
  for (const int y : {0, 63, 64, 128, 199}) mask[static_cast<size_t>(y * kSide + 100)] = 1;
  const Components components = label_components(mask, kSide, kSide);
  EXPECT_EQ(components.count, 5u);  // rows 63 and 64 touch
  EXPECT_EQ(components.label[20], 0);
  EXPECT_EQ(components.label[199 * kSide + 21], 0);
  EXPECT_EQ(components.label[100], 1);
  EXPECT_EQ(components.label[63 * kSide + 100], 2);
  EXPECT_EQ(components.label[64 * kSide + 100], 2);
  EXPECT_EQ(components.label[128 * kSide + 100], 3);
  EXPECT_EQ(components.label[199 * kSide + 100], 4);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, a filter that is too wide would be called acne before a contact and a leak behind it, and a map that is too
// coarse peter-panning.
#include "metrics/faults/blurred_edge.h"

#include "tests/unit/metrics/fault_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::add_map;
using testing::box_ramp;
using testing::classify_floor;
using testing::fault_floor;
using testing::for_floor_rectangle;
using testing::kFloorHeight;
using testing::kFloorPixel;
using testing::kFloorWidth;

Image half_plane(double width, double x0 = 1.0) {
  return fault_floor([=](double x, double) { return box_ramp(x - x0, width); });
}

size_t pixels_but(const Faults& faults, FaultClass but) {
  size_t pixels = 0;
  for (const FaultClass fault : faults.classes)
    pixels += fault != but && fault != FaultClass::explained ? 1 : 0;
  return pixels;
}

TEST(PenumbraTooWide, AWideFilterOnAHardEdge) {
  const Faults faults = classify_floor(half_plane(0.6), half_plane(0.01));
  EXPECT_GT(faults.of(FaultClass::penumbra_too_wide).pixels, 50u * kFloorHeight);
  EXPECT_EQ(pixels_but(faults, FaultClass::penumbra_too_wide), 0u);
}

TEST(PenumbraTooWide, AtAContactToo) {
  Image reference = half_plane(0.01);
  for_floor_rectangle(60, 0, 100, kFloorHeight,
                      [&](size_t i) { reference.plane("blocker_distance_min")[i] = 0.02f; });
  EXPECT_EQ(pixels_but(classify_floor(half_plane(0.6), reference), FaultClass::penumbra_too_wide), 0u);
  // The same contact with its shadow moved away from it.
  const Faults moved = classify_floor(half_plane(0.01, 0.7), reference);
  EXPECT_GT(moved.of(FaultClass::peter_panning).pixels, 20u * kFloorHeight);
  EXPECT_EQ(pixels_but(moved, FaultClass::peter_panning), 0u);
}

TEST(PenumbraTooWide, WhereTheSurfaceEndsAtTheEdge) {
  // A wall stands on the edge: of the blurred edge only the lit half is to be seen.
  Image reference = half_plane(0.01);
  for_floor_rectangle(0, 0, 98, kFloorHeight, [&](size_t i) {
    reference.plane("position.y")[i] = 1.0f;
    reference.plane("primitive_id")[i] = 7.0f;
  });
  Image test = reference;
  for_floor_rectangle(98, 0, kFloorWidth, kFloorHeight, [&](size_t i) {
    test.plane("visibility")[i] =
        static_cast<float>(box_ramp(static_cast<double>(test.plane("position.x")[i]) - 1.0, 0.6));
  });
  const Faults faults = classify_floor(test, reference);
  EXPECT_GT(faults.of(FaultClass::penumbra_too_wide).pixels, 15u * kFloorHeight);
  EXPECT_EQ(pixels_but(faults, FaultClass::penumbra_too_wide), 0u);
}

TEST(PenumbraTooWide, IsNotWhatIsTooHardOrMoved) {
  EXPECT_EQ(classify_floor(half_plane(0.05), half_plane(0.6)).of(FaultClass::penumbra_too_wide).pixels, 0u);
  for (const double x0 : {0.7, 1.3}) {
    const Faults faults = classify_floor(half_plane(0.1, x0), half_plane(0.1));
    EXPECT_EQ(faults.of(FaultClass::penumbra_too_wide).pixels, 0u) << x0;
  }
}

TEST(PenumbraTooWide, IsNotAcneThatTouchesAShadow) {
  const Image reference = half_plane(0.01);
  Image test = reference;
  for_floor_rectangle(100, 0, 200, kFloorHeight, [&](size_t i) {
    if (i / kFloorWidth % 8 < 4) test.plane("visibility")[i] = 0.25f;
  });
  const Faults faults = classify_floor(test, reference);
  EXPECT_EQ(faults.of(FaultClass::penumbra_too_wide).pixels, 0u);
  EXPECT_GT(faults.of(FaultClass::acne).pixels, 40u * kFloorHeight);
}

TEST(PenumbraTooWide, APictureBlurredAsAWholeAcrossOutlines) {
  // A dark box stands on lit ground; a blur of the picture takes its shade over its outline.
  Image reference = half_plane(0.01, 0.3);
  for_floor_rectangle(120, 30, 180, 90, [&](size_t i) {
    reference.plane("position.y")[i] = 1.0f;
    reference.plane("primitive_id")[i] = 7.0f;
    reference.plane("visibility")[i] = 0.0f;
    reference.plane("blocker_distance_min")[i] = 3.0f;
    reference.plane("blocker_layers")[i] = 1.0f;
  });
  const std::vector<uint8_t> all = testing::everywhere(reference);
  // Three box blurs of 9 px, not the metric's own Gaussian.
  Image test = reference;
  for (int pass = 0; pass < 3; ++pass) {
    const Image before = test;
    const auto v = before.plane("visibility");
    for (int y = 0; y < kFloorHeight; ++y) {
      for (int x = 0; x < kFloorWidth; ++x) {
        float sum = 0.0f;
        for (int dy = -4; dy <= 4; ++dy) {
          for (int dx = -4; dx <= 4; ++dx) {
            const int at_x = std::clamp(x + dx, 0, kFloorWidth - 1),
                      at_y = std::clamp(y + dy, 0, kFloorHeight - 1);
            sum += v[static_cast<size_t>(at_y * kFloorWidth + at_x)];
          }
        }
        test.plane("visibility")[static_cast<size_t>(y * kFloorWidth + x)] =
            std::clamp(sum / 81.0f, 0.0f, 1.0f);
      }
    }
  }
  const Faults faults = classify_floor(test, reference);
  EXPECT_GT(faults.of(FaultClass::penumbra_too_wide).mean_abs_error, 0.5 * *faults.mean_abs_error);
  EXPECT_LT(pixels_but(faults, FaultClass::penumbra_too_wide), 40u);
  EXPECT_TRUE(blurred_as_picture(half_plane(0.01, 0.5).plane("visibility"), reference.plane("visibility"),
                                 all, all, kFloorWidth, kFloorHeight)
                  .empty());
}

TEST(Resolution, AShadowThinnerThanATexelIsNotLostAndNotInContact) {
  // A post's shadow 3 px wide under texels of 40 px: not drawn, or drawn as wide as a texel.
  Image reference = fault_floor([](double, double) { return 1.0; });
  for_floor_rectangle(100, 40, 103, 90, [&](size_t i) {
    reference.plane("visibility")[i] = 0.0f;
    reference.plane("blocker_distance_min")[i] = 0.3f;  // in contact by texels alone
    reference.plane("blocker_layers")[i] = 1.0f;
  });
  Image test = fault_floor([](double, double) { return 1.0; });
  add_map(test, 40.0);
  const Faults lost = classify_floor(test, reference);
  EXPECT_EQ(lost.of(FaultClass::resolution).pixels, 150u);
  EXPECT_EQ(pixels_but(lost, FaultClass::resolution), 0u);

  for_floor_rectangle(80, 40, 120, 80, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  const Faults wide = classify_floor(test, reference);
  EXPECT_GT(wide.of(FaultClass::resolution).pixels, 1000u);
  EXPECT_EQ(pixels_but(wide, FaultClass::resolution), 0u);

  // From a fine map the same is what it was.
  for_floor_rectangle(80, 40, 120, 80, [&](size_t i) { test.plane("visibility")[i] = 1.0f; });
  add_map(test, 0.5);
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::resolution).pixels, 0u);
}

TEST(Terminator, SmoothedAwayOnFacetsThatShadowEachOther) {
  // Facets 3 degrees off the smooth normal, where the light grazes them, in their neighbours' shadow.
  Image reference = fault_floor([](double, double) { return 1.0; });
  const float tilt = static_cast<float>(3.0 * std::numbers::pi / 180.0);
  for_floor_rectangle(100, 20, 160, 100, [&](size_t i) {
    reference.plane("visibility")[i] = 0.0f;
    reference.plane("blocker_distance_min")[i] = 0.02f;
    reference.plane("blocker_layers")[i] = 1.0f;
    reference.plane("shading_normal.x")[i] = std::sin(tilt);
    reference.plane("shading_normal.y")[i] = std::cos(tilt);
    reference.plane("unshadowed_irradiance")[i] = 0.1f;
  });
  const Image test = fault_floor([](double, double) { return 1.0; });
  EXPECT_GT(classify_floor(test, reference).of(FaultClass::terminator).pixels, 4000u);
  // In full light the same is a contact's shadow that is gone.
  for_floor_rectangle(100, 20, 160, 100,
                      [&](size_t i) { reference.plane("unshadowed_irradiance")[i] = 1.0f; });
  EXPECT_EQ(classify_floor(test, reference).of(FaultClass::terminator).pixels, 0u);
}

}  // namespace
}  // namespace umbrameter

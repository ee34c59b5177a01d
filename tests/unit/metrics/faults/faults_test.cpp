// SPDX-License-Identifier: Apache-2.0
// Without these, a light leak could be called acne, or a wrong softness a leak.
#include "metrics/faults/faults.h"

#include "core/error.h"
#include "metrics/image/components.h"
#include "tests/unit/metrics/synthetic.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::everywhere;
using testing::floor_from_above;
using testing::lit_floor;

constexpr int kWidth = 256, kHeight = 128;
constexpr double kPixel = 0.01;

size_t at(int x, int y) {
  return static_cast<size_t>(y * kWidth + x);
}

// Dark for x < 1, penumbra of 0.2 (20 px), blocker 3 above, one layer.
Image half_plane(double width = 0.2) {
  Image image = lit_floor(floor_from_above(kWidth, kHeight, kPixel),
                          [width](double x, double) { return box_ramp(x - 1.0, width); });
  for (const char* axis : {"x", "y", "z"}) {
    const std::string name = axis;
    const std::span<const float> normal = std::as_const(image).plane("normal." + name);
    const std::span<float> shading = image.add_plane("shading_normal." + name);
    std::copy(normal.begin(), normal.end(), shading.begin());
  }
  const std::span<float> distance = image.add_plane("blocker_distance_min");
  const std::span<float> layers = image.add_plane("blocker_layers");
  for (size_t i = 0; i < distance.size(); ++i) {
    const bool shadowed = image.plane("visibility")[i] < 1.0f;
    distance[i] = shadowed ? 3.0f : 0.0f;
    layers[i] = shadowed ? 1.0f : 0.0f;
  }
  return image;
}

template <class Body>
size_t for_rectangle(int x0, int y0, int x1, int y1, const Body& body) {
  size_t pixels = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x, ++pixels) body(at(x, y));
  }
  return pixels;
}

Faults classify(const Image& test, const Image& reference, const FaultSettings& settings = {}) {
  const std::vector<uint8_t> mask = everywhere(reference);
  const PenumbraError penumbra = measure_penumbra(test, reference, mask);
  const Envelope envelope = measure_envelope(test, reference, mask, penumbra.profiles);
  return classify_faults(test, reference, mask, penumbra.profiles, envelope, settings);
}

size_t pixels_but(const Faults& faults, std::vector<FaultClass> but) {
  but.push_back(FaultClass::explained);
  size_t pixels = 0;
  for (const FaultClass fault : faults.classes)
    pixels += std::find(but.begin(), but.end(), fault) == but.end() ? 1 : 0;
  return pixels;
}

TEST(LabelComponents, JoinsDiagonalsAndConcaveShapes) {
  // A U whose arms meet at the bottom, a pixel touching it at a corner, and one apart.
  const std::vector<uint8_t> mask = {1, 0, 1, 0, 0,  //
                                     1, 0, 1, 0, 1,  //
                                     1, 1, 1, 0, 0,  //
                                     0, 0, 0, 1, 0};
  const Components components = label_components(mask, 5, 4);
  EXPECT_EQ(components.count, 2u);
  EXPECT_EQ(components.label[0], 0);
  EXPECT_EQ(components.label[2], 0);
  EXPECT_EQ(components.label[18], 0);
  EXPECT_EQ(components.label[9], 1);
  EXPECT_EQ(components.label[1], -1);
}

TEST(Faults, TheTruthHasNone) {
  const Image reference = half_plane();
  const Faults faults = classify(reference, reference);
  EXPECT_EQ(pixels_but(faults, {}), 0u);
  EXPECT_EQ(*faults.mean_abs_error, 0.0);
  EXPECT_FALSE(faults.peter_panning_gap_world);
}

TEST(Faults, APenumbraTenPercentWiderHasNone) {
  EXPECT_EQ(pixels_but(classify(half_plane(0.22), half_plane()), {}), 0u);
}

TEST(Faults, StripesOnLitGroundAreAcne) {
  const Image reference = half_plane();
  Image test = reference;
  size_t injected = 0;
  for (int x = 150; x < 220; x += 4) {
    injected += for_rectangle(x, 20, x + 2, 100, [&](size_t i) { test.plane("visibility")[i] = 0.75f; });
  }
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::acne).pixels, injected);
  EXPECT_EQ(pixels_but(faults, {FaultClass::acne}), 0u);
}

TEST(Faults, SpecklesCloseToAPenumbraAreAcneToo) {
  const Image reference = half_plane();
  Image test = reference;
  for (int y = 10; y < 120; y += 9) test.plane("visibility")[at(118, y)] = 0.0f;  // penumbra ends at x = 110
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::acne).components, 13u);
  EXPECT_EQ(pixels_but(faults, {FaultClass::acne}), 0u);
}

TEST(Faults, ASlitInTheUmbraIsAGeometricLeak) {
  const Image reference = half_plane();
  Image test = reference;
  const size_t injected =
      for_rectangle(40, 10, 43, 110, [&](size_t i) { test.plane("visibility")[i] = 1.0f; });
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::geometric_leak).pixels, injected);
  EXPECT_EQ(faults.of(FaultClass::geometric_leak).components, 1u);
  EXPECT_EQ(pixels_but(faults, {FaultClass::geometric_leak}), 0u);
}

TEST(Faults, AGapUnderAnObjectInContactIsPeterPanning) {
  Image reference = half_plane();
  for_rectangle(20, 20, 60, 100, [&](size_t i) { reference.plane("blocker_distance_min")[i] = 0.02f; });
  Image test = reference;
  const size_t injected =
      for_rectangle(30, 30, 36, 90, [&](size_t i) { test.plane("visibility")[i] = 1.0f; });
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::peter_panning).pixels, injected);
  // Six pixels of 0.01: the innermost is 3 px from a pixel outside, 2 * 3 - 1 = 5; even strips lose one.
  EXPECT_NEAR(*faults.peter_panning_gap_world, 0.055, 0.006);
  // The same light is no contact gap when contact means closer than a centimetre.
  const Faults strict = classify(test, reference, {.contact_distance_world = 0.01});
  EXPECT_EQ(strict.of(FaultClass::peter_panning).pixels, 0u);
  EXPECT_EQ(strict.of(FaultClass::geometric_leak).pixels, injected);
}

TEST(Faults, ABiasReachesAsFarAsItIsLong) {
  Image reference = half_plane();
  for_rectangle(20, 20, 60, 100, [&](size_t i) { reference.plane("blocker_distance_min")[i] = 0.3f; });
  Image test = reference;
  for (const char* channel : {"texel.x", "texel.y"}) test.add_plane(channel);
  test.add_plane("texel_world", 0.01f);
  const size_t injected =
      for_rectangle(30, 30, 36, 90, [&](size_t i) { test.plane("visibility")[i] = 1.0f; });
  EXPECT_EQ(classify(test, reference).of(FaultClass::geometric_leak).pixels, injected);
  test.add_plane("bias_world", 0.2f);
  EXPECT_EQ(classify(test, reference).of(FaultClass::peter_panning).pixels, injected);
  test.plane("bias_world")[0] = -1.0f;
  EXPECT_THROW(classify(test, reference), Error);
}

TEST(Faults, DimLightBehindTwoBlockersIsBleed) {
  Image reference = half_plane();
  for_rectangle(10, 20, 70, 100, [&](size_t i) { reference.plane("blocker_layers")[i] = 2.0f; });
  Image test = reference;
  const size_t injected =
      for_rectangle(20, 30, 50, 90, [&](size_t i) { test.plane("visibility")[i] = 0.15f; });
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::bleed).pixels, injected);
  EXPECT_EQ(pixels_but(faults, {FaultClass::bleed}), 0u);
}

TEST(Faults, AShadowOfItsOwnThatIsMissingIsLostThoughThin) {
  Image reference = half_plane();
  size_t thin = 0;
  for (int y = 20; y < 100; ++y) {  // 2 px wide core between half-lit rims, inside what the envelope excuses
    for (const auto& [x, v] : {std::pair{180, 0.6f}, {181, 0.1f}, {182, 0.1f}, {183, 0.6f}}) {
      reference.plane("visibility")[at(x, y)] = v;
      ++thin;
    }
  }
  const Faults faults = classify(half_plane(), reference);
  EXPECT_EQ(faults.of(FaultClass::lost_shadow).pixels, thin);
  EXPECT_EQ(faults.of(FaultClass::lost_shadow).components, 1u);
}

TEST(Faults, ASolidDarkShapeIsAnExtraShadowAndAThinOneAcne) {
  const Image reference = half_plane();
  Image test = reference;
  const size_t solid = for_rectangle(160, 40, 190, 80, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  const size_t thin = for_rectangle(220, 40, 224, 80, [&](size_t i) { test.plane("visibility")[i] = 0.0f; });
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::extra_shadow).pixels, solid);
  EXPECT_EQ(faults.of(FaultClass::acne).pixels, thin);
}

TEST(Faults, DarkFacetsWhereNormalsDisagreeAreTheTerminator) {
  Image reference = half_plane();
  for_rectangle(190, 0, 256, kHeight, [&](size_t i) {  // 20 degrees
    reference.plane("shading_normal.x")[i] = std::sin(0.35f);
    reference.plane("shading_normal.y")[i] = std::cos(0.35f);
  });
  Image test = reference;
  const size_t injected =
      for_rectangle(200, 10, 206, 110, [&](size_t i) { test.plane("visibility")[i] = 0.3f; });
  const Faults faults = classify(test, reference);
  EXPECT_EQ(faults.of(FaultClass::terminator).pixels, injected);
  EXPECT_EQ(faults.of(FaultClass::acne).pixels, 0u);
}

TEST(Faults, WrongSoftnessIsOfThePenumbra) {
  for (const double factor : {0.05, 0.5, 2.0, 3.0}) {
    const FaultClass softness = factor < 1.0 ? FaultClass::penumbra : FaultClass::penumbra_too_wide;
    const Faults faults = classify(half_plane(0.2 * factor), half_plane());
    EXPECT_GT(faults.of(softness).pixels, 200u) << factor;
    EXPECT_EQ(pixels_but(faults, {softness}), 0u) << factor;
  }
}

TEST(Faults, SharesAddUpToTheErrorOfTheImage) {
  const Image reference = half_plane();
  Image test = half_plane(0.5);
  std::mt19937 random(8);
  for (int k = 0; k < 3000; ++k) {
    test.plane("visibility")[random() % test.pixel_count()] = static_cast<float>(random() % 1000) / 1000.0f;
  }
  const Faults faults = classify(test, reference);
  double sum = 0.0;
  size_t pixels = 0;
  for (const FaultShare& share : faults.by_class) {
    sum += share.mean_abs_error;
    pixels += share.pixels;
  }
  EXPECT_EQ(pixels, test.pixel_count());
  EXPECT_NEAR(sum, *faults.mean_abs_error, 1e-12);
  EXPECT_NEAR(sum, *measure_visibility_error(test, reference, everywhere(test)).mae, 1e-12);
}

TEST(Faults, NothingScoredIsNotApplicable) {
  const Image reference = half_plane();
  const std::vector<uint8_t> mask(reference.pixel_count(), 0);
  const Envelope envelope = measure_envelope(reference, reference, mask, {});
  const Faults faults = classify_faults(reference, reference, mask, {}, envelope);
  EXPECT_FALSE(faults.mean_abs_error);
  EXPECT_EQ(faults.of(FaultClass::unscored).pixels, reference.pixel_count());
}

TEST(Faults, NeedsTheBlockersOfTheReference) {
  Image reference = half_plane();
  reference.planes.erase("blocker_layers");
  try {
    classify(reference, reference);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("blocker_layers"), std::string::npos) << error.what();
  }
}

TEST(Faults, EveryClassHasAName) {
  EXPECT_EQ(name_of(FaultClass::unscored), "unscored");
  EXPECT_EQ(name_of(FaultClass::peter_panning), "peter_panning");
  EXPECT_EQ(name_of(FaultClass::lost_shadow), "lost_shadow");
}

}  // namespace
}  // namespace umbrameter

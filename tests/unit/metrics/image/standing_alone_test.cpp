// SPDX-License-Identifier: Apache-2.0
// Acne and leaks close to a shadow must not hide behind its penumbra; a penumbra that is wider must not be called either.
#include "metrics/image/standing_alone.h"

#include "tests/unit/metrics/fault_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::classify_floor;
using testing::fault_floor;
using testing::floor_at;
using testing::for_floor_rectangle;
using testing::kFloorHeight;
using testing::kFloorPixel;
using testing::kFloorWidth;

// Shadow on the left, light from x = 1.2 on (pixel 120); the penumbra is 40 px wide, its envelope 7 px.
constexpr int kLightFrom = 120, kShadowTo = 80;

Image half_plane(double width = 0.4) {
  return fault_floor([width](double x, double) { return box_ramp(x - 1.0, width); });
}

// Visibility at x is that of the row, by a function of the pixel.
template <class V, class R>
bool alone_in_row(const V& v, const R& r, size_t at, double reach_px, float sign = 1.0f) {
  std::vector<float> test, truth;
  for (size_t x = 0; x < 64; ++x) {
    test.push_back(v(x));
    truth.push_back(r(x));
  }
  const std::vector<uint8_t> mask(64, 1);
  const Image floor = testing::floor_from_above(64, 1, kFloorPixel);
  return stands_alone({test, truth, mask, checked_surface(floor), sign}, at, reach_px, 0.02f);
}

float ramp(size_t x, float from, float to) {
  return std::clamp((static_cast<float>(x) - from) / (to - from), 0.0f, 1.0f);
}

TEST(StandingAlone, APenumbraThatReachesFurtherDoesNot) {
  const auto truth = [](size_t x) { return ramp(x, 10.0f, 30.0f); };
  const auto wider = [](size_t x) { return ramp(x, 5.0f, 35.0f); };
  for (const size_t x : {31u, 32u, 33u}) EXPECT_FALSE(alone_in_row(wider, truth, x, 12.0)) << x;
}

TEST(StandingAlone, DarkWithLightBetweenItAndTheShadowDoes) {
  const auto truth = [](size_t x) { return ramp(x, 10.0f, 30.0f); };
  const auto speck = [&](size_t x) { return x == 33 ? 0.5f : truth(x); };
  EXPECT_TRUE(alone_in_row(speck, truth, 33, 40.0));
  // Where light between is no lighter than grain makes it, it is no evidence.
  const auto grain = [&](size_t x) { return x == 33 ? 0.94f : truth(x); };
  EXPECT_FALSE(alone_in_row(grain, truth, 33, 40.0));
}

TEST(StandingAlone, HasAMirrorImageInTheShadow) {
  const auto truth = [](size_t x) { return 1.0f - ramp(x, 10.0f, 30.0f); };
  const auto leak = [&](size_t x) { return x == 33 ? 0.5f : truth(x); };
  const auto wider = [](size_t x) { return 1.0f - ramp(x, 5.0f, 35.0f); };
  EXPECT_TRUE(alone_in_row(leak, truth, 33, 40.0, -1.0f));
  EXPECT_FALSE(alone_in_row(wider, truth, 33, 12.0, -1.0f));
}

TEST(StandingAlone, EndsAtTheMaskAndAtTheReach) {
  std::vector<float> test(64, 0.5f), truth(64, 1.0f);
  truth[0] = 0.0f;
  std::vector<uint8_t> mask(64, 1);
  const Image floor = testing::floor_from_above(64, 1, kFloorPixel);
  const Outskirts row = {test, truth, mask, checked_surface(floor), 1.0f};
  EXPECT_FALSE(stands_alone(row, 10, 10.0, 0.02f));
  EXPECT_TRUE(stands_alone(row, 10, 9.0, 0.02f));
  mask[5] = 0;
  EXPECT_TRUE(stands_alone(row, 10, 10.0, 0.02f));
}

TEST(StandingAlone, NoShadowCreepsOverAnOutlineButLightMay) {
  // A step from pixel 20 on: shadow below, light above.
  Image step = testing::floor_from_above(64, 1, kFloorPixel);
  std::vector<float> test(64, 0.5f), truth(64, 1.0f);
  for (size_t x = 0; x < 20; ++x) {
    step.plane("position.y")[x] = -1.0f;
    step.plane("primitive_id")[x] = 1.0f;
    truth[x] = 0.0f;
  }
  const std::vector<uint8_t> mask(64, 1);
  EXPECT_TRUE(stands_alone({test, truth, mask, checked_surface(step), 1.0f}, 22, 10.0, 0.02f));
  EXPECT_FALSE(stands_alone({test, truth, mask, checked_surface(step), -1.0f}, 17, 10.0, 0.02f));
  for (size_t x = 0; x < 20; ++x) step.plane("position.y")[x] = 0.0f;
  EXPECT_FALSE(stands_alone({test, truth, mask, checked_surface(step), 1.0f}, 22, 10.0, 0.02f));
}

TEST(FaultsBesideAShadow, SpecklesAndStripesAreAcne) {
  const Image reference = half_plane();
  Image test = reference;
  const std::span<float> v = test.plane("visibility");
  std::vector<uint8_t> painted(v.size(), 0);
  for (int y = 2; y < kFloorHeight; y += 8) {  // two to nine pixels into the light
    const size_t i = floor_at(kLightFrom + 2 + y / 8 % 8, y);
    v[i] -= 0.5f;
    painted[i] = 1;
  }
  for_floor_rectangle(kLightFrom + 1, 70, kLightFrom + 60, 73, [&](size_t i) {
    v[i] = 0.7f;
    painted[i] = 1;
  });
  const Faults faults = classify_floor(test, reference);
  for (size_t i = 0; i < v.size(); ++i) {
    EXPECT_EQ(faults.classes[i] == FaultClass::acne, painted[i] != 0)
        << i % kFloorWidth << " " << i / kFloorWidth;
  }
}

TEST(FaultsBesideAShadow, ALineOfLightInItIsALeak) {
  const Image reference = half_plane();
  Image test = reference;
  const size_t painted = for_floor_rectangle(kShadowTo - 5, 20, kShadowTo - 2, 100,
                                             [&](size_t i) { test.plane("visibility")[i] = 0.9f; });
  const Faults faults = classify_floor(test, reference);
  EXPECT_EQ(faults.of(FaultClass::geometric_leak).pixels, painted);
}

TEST(FaultsBesideAShadow, AWiderPenumbraIsNeither) {
  for (const double width : {0.44, 0.5, 0.8}) {
    const Faults faults = classify_floor(half_plane(width), half_plane());
    EXPECT_EQ(faults.of(FaultClass::acne).pixels, 0u) << width;
    EXPECT_EQ(faults.of(FaultClass::geometric_leak).pixels, 0u) << width;
  }
}

}  // namespace
}  // namespace umbrameter

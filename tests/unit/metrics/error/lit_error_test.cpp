// SPDX-License-Identifier: Apache-2.0
// Without these, the error of the lit picture could be in another unit, or hold the reference's noise.

#include "metrics/error/lit_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

/// Two pixels: E = 3 and 4; V of the truth .5 and 1, S .8 and 1; halves .1 to either side.
Image truth() {
  Image image(2, 1);
  image.planes["unshadowed_irradiance"] = {3.0f, 4.0f};
  image.planes["visibility"] = {0.5f, 1.0f};
  image.planes["half_a"] = {0.6f, 1.0f};
  image.planes["half_b"] = {0.4f, 1.0f};
  image.planes["irradiance_half_a"] = {0.9f, 1.0f};
  image.planes["irradiance_half_b"] = {0.7f, 1.0f};
  return image;
}

const std::vector<uint8_t> kBoth = {1, 1};

TEST(LitError, WeighsByUnshadowedIrradianceAndTakesTheNoiseOut) {
  Image test(2, 1);
  test.planes["visibility"] = {0.3f, 0.6f};
  // (9 (.3 - .9)(.3 - .7) + 16 (-.4)^2) / 25 = (2.16 + 2.56) / 25
  EXPECT_NEAR(measure_lit_error(test, truth(), kBoth).value(), std::sqrt(4.72 / 25.0), 1e-6);
}

TEST(LitError, APerfectVisibilityHasTheModelGap) {
  const ModelGap gap = measure_model_gap(truth(), kBoth).value();
  // (.9 - .6)(.7 - .4) = .09 on one of two pixels.
  EXPECT_NEAR(gap.rmse, std::sqrt(0.09 / 2.0), 1e-6);
  EXPECT_NEAR(gap.lit_rmse, std::sqrt(9.0 * 0.09 / 25.0), 1e-6);
}

TEST(LitError, IsAbsentWithoutLightOrPixels) {
  EXPECT_FALSE(measure_lit_error(truth(), truth(), std::vector<uint8_t>{0, 0}));
  EXPECT_FALSE(measure_model_gap(truth(), std::vector<uint8_t>{0, 0}));
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these, the worst pixels could be those of a background, or too many of them.

#include "metrics/error/worst_pixels.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

Image grey(int width, float visibility) {
  Image image(width, 1);
  image.planes["visibility"].assign(static_cast<size_t>(width), visibility);
  return image;
}

TEST(WorstPixels, AreTheHundredthThatIsFarthestOff) {
  Image test = grey(200, 0.5f);
  test.planes["visibility"][17] = 1.0f;   // .5 too bright
  test.planes["visibility"][150] = 0.2f;  // .3 too dark
  test.planes["visibility"][151] = 0.4f;
  const std::vector<uint8_t> all(200, 1);
  EXPECT_NEAR(measure_worst_pixels(test, grey(200, 0.5f), all).value(), std::sqrt((0.25 + 0.09) / 2.0), 1e-7);
}

TEST(WorstPixels, LeaveOutWhatIsNotScored) {
  Image test = grey(50, 0.5f);
  test.planes["visibility"][0] = 1.0f;
  test.planes["visibility"][1] = 0.75f;
  std::vector<uint8_t> mask(50, 1);
  mask[0] = 0;
  EXPECT_NEAR(measure_worst_pixels(test, grey(50, 0.5f), mask).value(), 0.25, 1e-7);  // one of 49
  EXPECT_FALSE(measure_worst_pixels(test, grey(50, 0.5f), std::vector<uint8_t>(50, 0)));
  EXPECT_THROW(measure_worst_pixels(test, grey(49, 0.5f), mask), Error);
}

}  // namespace
}  // namespace umbrameter

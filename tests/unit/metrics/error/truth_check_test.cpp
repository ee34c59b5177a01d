// SPDX-License-Identifier: Apache-2.0
// Without these a reference whose halves are not independent, or that samples one point of the light, could be believed.

#include "metrics/error/truth_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kSize = 64;
const std::vector<uint8_t> kAll(kSize* kSize, 1);

/// A ramp over `ramp_px` columns in the middle; halves scatter by sqrt(2) of the standard error.
Image ramp(int ramp_px, double se) {
  Image image(kSize, kSize);
  const auto r = image.add_plane("visibility"), a = image.add_plane("half_a"), b = image.add_plane("half_b");
  image.add_plane("visibility_se", static_cast<float>(se));
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, std::sqrt(2.0) * se);
  for (size_t i = 0; i < r.size(); ++i) {
    const double x = static_cast<double>(i % kSize) + 0.5 - kSize / 2;
    const double truth = std::clamp(0.5 + x / std::max(1, ramp_px), 0.0, 1.0);
    const bool is_partial = truth > 0.02 && truth < 0.98;
    a[i] = static_cast<float>(truth + (is_partial ? noise(random) : 0.0));
    b[i] = static_cast<float>(truth + (is_partial ? noise(random) : 0.0));
    r[i] = 0.5f * (a[i] + b[i]);
  }
  return image;
}

TEST(TruthCheck, IndependentHalvesPass) {
  EXPECT_THAT(truth_problems(ramp(20, 0.005), kAll), IsEmpty());
}

TEST(TruthCheck, OneSeedForBothHalvesIsFound) {
  Image image = ramp(20, 0.005);
  image.planes["half_b"] = image.planes["half_a"];
  EXPECT_THAT(truth_problems(image, kAll), ElementsAre(HasSubstr("halves differ 0 times")));
}

TEST(TruthCheck, AStandardErrorThatIsFarTooSmallIsFound) {
  Image image = ramp(20, 0.005);
  for (float& se : image.plane("visibility_se")) se = 0.002f;
  EXPECT_THAT(truth_problems(image, kAll), ElementsAre(HasSubstr("times as much")));
}

TEST(TruthCheck, ALightWithoutPenumbraIsAPoint) {
  EXPECT_THAT(truth_problems(ramp(0, 0.0), kAll), ElementsAre(HasSubstr("64 edges")));
  EXPECT_THAT(truth_problems(ramp(4, 0.001), kAll), IsEmpty());
}

TEST(TruthCheck, NothingIsSaidOfPixelsThatAreNotScored) {
  EXPECT_THAT(truth_problems(ramp(0, 0.0), std::vector<uint8_t>(kAll.size(), 0)), IsEmpty());
}

}  // namespace
}  // namespace umbrameter

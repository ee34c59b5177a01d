// SPDX-License-Identifier: Apache-2.0
// Without these, noise of a still scene could pass for a trail, or frames that mend nothing for convergence.

#include "metrics/temporal/history.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kWidth = 100;

Image picture(float visibility) {
  Image image(kWidth, 1);
  image.planes["visibility"].assign(kWidth, visibility);
  return image;
}

/// Two halves that err by as much in opposite ways.
Image truth(float visibility, float noise = 0.0f) {
  Image image(kWidth, 1);
  image.planes["half_a"].assign(kWidth, visibility + noise);
  image.planes["half_b"].assign(kWidth, visibility - noise);
  return image;
}

const std::vector<uint8_t> kAll(kWidth, 1);

TEST(Ghosting, IsWhatMotionAddsToTheError) {
  // A tenth of the pixels keeps .5 of the old shadow; all are .1 off wherever nothing moves.
  const Image still = picture(0.6f);
  Image test = still;
  for (size_t i = 0; i < kWidth / 10; ++i) test.planes["visibility"][i] = 1.0f;
  const double moved = (0.1 * 0.5 * 0.5 + 0.9 * 0.01), stood = 0.01;
  EXPECT_NEAR(*measure_ghosting(test, still, truth(0.5f), kAll), std::sqrt(moved - stood), 1e-6);
  EXPECT_NEAR(*measure_ghosting(test, still, truth(0.5f, 0.05f), kAll), std::sqrt(moved - stood), 1e-6);
  EXPECT_EQ(*measure_ghosting(still, still, truth(0.5f), kAll), 0.0);
  EXPECT_LT(*measure_ghosting(picture(0.5f), still, truth(0.5f), kAll), 0.0);
}

TEST(Ghosting, LeavesOutWhatIsNotScored) {
  Image test = picture(0.5f);
  test.planes["visibility"][3] = 1.0f;
  std::vector<uint8_t> mask = kAll;
  mask[3] = 0;
  EXPECT_EQ(*measure_ghosting(test, picture(0.5f), truth(0.5f), mask), 0.0);
  EXPECT_FALSE(measure_ghosting(test, picture(0.5f), truth(0.5f), std::vector<uint8_t>(kWidth, 0)));
  EXPECT_THROW(measure_ghosting(test, picture(0.5f), truth(0.5f), std::vector<uint8_t>(3, 1)), Error);
}

/// Pictures whose errors are `errors`, after 1, 2, 4, ... frames.
std::optional<double> convergence(const std::vector<float>& errors) {
  std::vector<Image> images;
  for (const float error : errors) images.push_back(picture(0.5f + error));
  std::vector<StillPicture> pictures;
  for (size_t k = 0; k < images.size(); ++k) pictures.push_back({1 << k, &images[k]});
  return measure_convergence(pictures, truth(0.5f), kAll);
}

TEST(Convergence, IsWhereNineTenthsAreMended) {
  // .2 less is mended in all: the goal is .12.
  EXPECT_NEAR(*convergence({0.3f, 0.2f, 0.12f, 0.1f}), 4.0, 1e-4);
  // Half way from .16 at 4 frames to .08 at 8, over their logarithm.
  EXPECT_NEAR(*convergence({0.28f, 0.2f, 0.16f, 0.1f, 0.1f}), 4.0 * std::pow(2.0, 0.042 / 0.06), 1e-3);
  EXPECT_NEAR(*convergence({0.3f, 0.1f, 0.1f}), std::pow(2.0, 0.9), 1e-4);
}

TEST(Convergence, IsAbsentWhereFramesMendNothing) {
  EXPECT_FALSE(convergence({0.1f, 0.1f, 0.1f}));
  EXPECT_FALSE(convergence({0.1f, 0.2f}));
  EXPECT_FALSE(convergence({0.1005f, 0.1f}));
  EXPECT_THROW(convergence({0.1f}), Error);
}

}  // namespace
}  // namespace umbrameter

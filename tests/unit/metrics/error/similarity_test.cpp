// SPDX-License-Identifier: Apache-2.0
// Without these, PSNR or SSIM could be of another range or window than readers assume.
#include "metrics/error/similarity.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

Image grey(int width, int height, float value) {
  Image image(width, height);
  image.add_plane("y", value);
  return image;
}

TEST(Psnr, ATenthApartIsTwentyDecibels) {
  EXPECT_NEAR(*measure_psnr_db(grey(20, 10, 0.5f), grey(20, 10, 0.6f), "y"), 20.0, 1e-5);
}

TEST(Psnr, EqualPicturesAreInfinitelyCloseAndNoneAreNotApplicable) {
  EXPECT_EQ(*measure_psnr_db(grey(20, 10, 0.5f), grey(20, 10, 0.5f), "y"), INFINITY);
  EXPECT_FALSE(measure_psnr_db(grey(0, 0, 0.5f), grey(0, 0, 0.5f), "y"));
}

TEST(Ssim, EqualPicturesAreOne) {
  Image a = grey(40, 30, 0.0f);
  for (size_t i = 0; i < a.pixel_count(); ++i) a.plane("y")[i] = static_cast<float>(i % 7) / 7.0f;
  EXPECT_NEAR(*measure_ssim(a, a, "y"), 1.0, 1e-6);
}

TEST(Ssim, FlatPicturesCompareByLuminanceAlone) {
  // (2 * .5 * .6 + 1e-4) / (.25 + .36 + 1e-4) = .6001 / .6101; moments in single precision leave
  // some 1e-7 against the contrast guard of 9e-4.
  EXPECT_NEAR(*measure_ssim(grey(40, 30, 0.5f), grey(40, 30, 0.6f), "y"), 0.6001 / 0.6101, 3e-4);
}

TEST(Ssim, AnInvertedPatternIsNegativelySimilar) {
  Image a = grey(40, 30, 0.0f), b = a;
  for (size_t i = 0; i < a.pixel_count(); ++i) {
    a.plane("y")[i] = (i + i / 40) % 2 == 0 ? 0.0f : 1.0f;
    b.plane("y")[i] = 1.0f - a.plane("y")[i];
  }
  // Means .5, variances .25, covariance -.25: (-.5 + 9e-4) / (.5 + 9e-4).
  EXPECT_NEAR(*measure_ssim(a, b, "y"), (-0.5 + 9e-4) / (0.5 + 9e-4), 1e-3);
}

TEST(Ssim, APictureSmallerThanTheWindowIsNotApplicable) {
  EXPECT_FALSE(measure_ssim(grey(10, 40, 0.5f), grey(10, 40, 0.5f), "y"));
}

TEST(Similarity, RejectsValuesOutOfRangeAndOtherSizes) {
  EXPECT_THROW(measure_ssim(grey(20, 20, 1.5f), grey(20, 20, 0.5f), "y"), Error);
  EXPECT_THROW(measure_psnr_db(grey(20, 20, 0.5f), grey(20, 20, std::nanf("")), "y"), Error);
  EXPECT_THROW(measure_psnr_db(grey(20, 20, 0.5f), grey(20, 21, 0.5f), "y"), Error);
}

}  // namespace
}  // namespace umbrameter

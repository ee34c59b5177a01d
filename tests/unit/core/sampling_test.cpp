// SPDX-License-Identifier: Apache-2.0
// Without these: a pattern could lose its stratification, or two seeds could give correlated sets.
#include "core/sampling/patterns.h"
#include "core/sampling/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace umbrameter {
namespace {

TEST(Sobol, FirstPointsAreThePublishedOnes) {
  // Joe and Kuo, dimensions 1 and 2 (no Gray code): 0, 1/2, 1/4, 3/4, ... and 0, 1/2, 3/4, 1/4, 5/8, 1/8,
  // 3/8, 7/8.
  const double x[] = {0, .5, .25, .75, .125, .625, .375, .875};
  const double y[] = {0, .5, .75, .25, .625, .125, .375, .875};
  for (uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(sobol_point(i).x * 0x1p-32, x[i]) << i;
    EXPECT_EQ(sobol_point(i).y * 0x1p-32, y[i]) << i;
  }
}

TEST(Sobol, EveryElementaryIntervalOf256ScrambledPointsHoldsOne) {
  for (const uint32_t seed : {1u, 77u, 0xdeadbeefu}) {
    for (int log_columns = 0; log_columns <= 8; ++log_columns) {
      const int columns = 1 << log_columns;
      const int rows = 256 / columns;
      std::vector<int> hits(256, 0);
      for (uint32_t i = 0; i < 256; ++i) {
        const glm::vec2 p = scrambled_sobol(i, seed);
        ++hits[static_cast<size_t>(static_cast<int>(p.x * static_cast<float>(columns)) +
                                   columns * static_cast<int>(p.y * static_cast<float>(rows)))];
      }
      for (const int count : hits) ASSERT_EQ(count, 1) << "seed " << seed << ", " << columns << " columns";
    }
  }
}

TEST(Sobol, MeansOfDifferentSeedsAreIndependent) {
  // Two-point sets: the mean's error has some variance v per seed; the mean over 1024 seeds must shrink it to
  // v/1024.
  double sum = 0.0;
  double sum_squares = 0.0;
  constexpr int kSeeds = 1024;
  for (uint32_t seed = 0; seed < kSeeds; ++seed) {
    const double mean = 0.5 * (scrambled_sobol(0, seed).x + scrambled_sobol(1, seed).x);
    sum += mean - 0.5;
    sum_squares += (mean - 0.5) * (mean - 0.5);
  }
  const double standard_error = std::sqrt(sum_squares / kSeeds / kSeeds);
  EXPECT_LT(std::abs(sum / kSeeds), 4.0 * standard_error);
  // Two stratified points: each uniform in its half, so the mean has variance (1/48 + 1/48) / 4 = 1/96.
  EXPECT_NEAR(sum_squares / kSeeds, 1.0 / 96.0, 0.15 / 96.0);
}

TEST(VogelDisk, StaysInTheUnitDiskAndIsUniformInArea) {
  constexpr uint32_t kCount = 1000;
  int inside_half_area = 0;
  for (uint32_t i = 0; i < kCount; ++i) {
    const glm::vec2 p = vogel_disk(i, kCount, 0.3f);
    const float radius2 = p.x * p.x + p.y * p.y;
    ASSERT_LT(radius2, 1.0f);
    if (radius2 < 0.5f) ++inside_half_area;
  }
  EXPECT_EQ(inside_half_area, 500);  // r^2 = (i + .5) / n is below 1/2 for exactly half the points
}

TEST(InterleavedGradientNoise, MatchesAHandComputedValue) {
  // fract(52.9829189 * fract(0.06711056 * 10.5 + 0.00583715 * 20.5)) = fract(52.9829189 * 0.824322455) =
  // 0.67501...
  EXPECT_NEAR(interleaved_gradient_noise({10.5f, 20.5f}), std::fmod(52.9829189 * 0.824322455, 1.0), 2e-4);
}

TEST(Hammersley, FirstAxisIsRegularAndSecondIsBitReversed) {
  EXPECT_FLOAT_EQ(hammersley(3, 8).x, 3.5f / 8.0f);
  EXPECT_FLOAT_EQ(hammersley(3, 8).y, 0.75f);  // 3 = 011b -> .110b
}

TEST(ConcentricDisk, PreservesAreaAndKeepsTheBoundary) {
  constexpr int kSide = 200;
  int inside_half_radius = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const glm::vec2 p =
          concentric_disk({(static_cast<float>(x) + .5f) / kSide, (static_cast<float>(y) + .5f) / kSide});
      const float radius = std::hypot(p.x, p.y);
      ASSERT_LE(radius, 1.0f);
      if (radius < 0.5f) ++inside_half_radius;
    }
  }
  EXPECT_EQ(inside_half_radius,
            kSide * kSide / 4);  // the map takes squares of half the side to half the radius
  EXPECT_NEAR(concentric_disk({1.0f, 0.5f}).x, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace umbrameter

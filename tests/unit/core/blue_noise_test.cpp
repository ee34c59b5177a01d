// SPDX-License-Identifier: Apache-2.0
#include "core/sampling/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace umbrameter {
namespace {

constexpr uint32_t kSide = kBlueNoiseSide;

/// Of one frequency, as a share of what white noise of the same values has on average.
double relative_power(const std::vector<uint32_t>& ranks, uint32_t u, uint32_t v) {
  const double count = static_cast<double>(ranks.size());
  std::complex<double> sum = 0.0;
  for (uint32_t i = 0; i < ranks.size(); ++i) {
    const double turns = static_cast<double>(u * (i % kSide) + v * (i / kSide)) / kSide;
    sum += ((ranks[i] + 0.5) / count - 0.5) * std::polar(1.0, 2.0 * std::numbers::pi * turns);
  }
  return std::norm(sum) / (count / 12.0);
}

/// The mean over frequencies of so many cycles a side.
double mean_power(const std::vector<uint32_t>& ranks, double least, double most) {
  double sum = 0.0, count = 0.0;
  for (uint32_t v = 0; v < kSide; ++v) {
    for (uint32_t u = 0; u < kSide; ++u) {
      const double cycles = std::hypot(std::min(u, kSide - u), std::min(v, kSide - v));
      if (cycles < least || cycles > most) continue;
      sum += relative_power(ranks, u, v);
      count += 1.0;
    }
  }
  return sum / count;
}

TEST(blue_noise, has_each_rank_once_and_always_the_same) {
  std::vector<uint32_t> ranks = blue_noise_ranks();
  EXPECT_EQ(ranks, blue_noise_ranks());
  EXPECT_EQ(ranks.size(), size_t{kSide} * kSide);
  std::ranges::sort(ranks);
  for (uint32_t i = 0; i < ranks.size(); ++i) ASSERT_EQ(ranks[i], i);
}

TEST(blue_noise, has_hardly_any_low_frequencies) {
  const std::vector<uint32_t> ranks = blue_noise_ranks();
  EXPECT_LT(mean_power(ranks, 1.0, kSide / 8.0), 0.1);
  EXPECT_LT(mean_power(ranks, 1.0, kSide / 16.0), 0.02);
  EXPECT_GT(mean_power(ranks, kSide / 3.0, kSide / 2.0), 1.0);
}

// A sixteenth of the pixels: any two of them lie apart.
TEST(blue_noise, spreads_its_first_ranks) {
  const std::vector<uint32_t> ranks = blue_noise_ranks();
  std::vector<uint32_t> first;
  for (uint32_t i = 0; i < ranks.size(); ++i)
    if (ranks[i] < ranks.size() / 16) first.push_back(i);
  double nearest = kSide;
  for (const uint32_t a : first) {
    for (const uint32_t b : first) {
      const uint32_t x = (a % kSide + kSide - b % kSide) % kSide, y = (a / kSide + kSide - b / kSide) % kSide;
      const double apart = std::hypot(std::min(x, kSide - x), std::min(y, kSide - y));
      if (a != b) nearest = std::min(nearest, apart);
    }
  }
  EXPECT_GE(nearest, 2.0);  // a lattice's are 4 px apart, random ones 1
}

}  // namespace
}  // namespace umbrameter

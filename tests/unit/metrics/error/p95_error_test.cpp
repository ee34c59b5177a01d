// SPDX-License-Identifier: Apache-2.0
// Without these, noise of the truth could pass for an error, or a background for a score.

#include "metrics/error/p95_error.h"

#include "core/error.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

Image row_of(int width, float visibility, float se = 0.0f) {
  Image image(width, 1);
  image.planes["visibility"].assign(static_cast<size_t>(width), visibility);
  image.planes["visibility_se"].assign(static_cast<size_t>(width), se);
  return image;
}

TEST(P95Error, IsWhatOnePixelInTwentyExceeds) {
  Image test = row_of(100, 0.0f);
  for (size_t i = 0; i < 100; ++i) test.planes["visibility"][i] = static_cast<float>(i + 1) / 100.0f;
  const std::vector<uint8_t> all(100, 1);
  EXPECT_NEAR(measure_p95_error(test, row_of(100, 0.0f), all).value(), 0.95, 1e-6);
}

TEST(P95Error, WhatBothCallLitDoesNotCount) {
  Image test = row_of(100, 1.0f), reference = row_of(100, 1.0f);
  const std::vector<uint8_t> all(100, 1);
  EXPECT_FALSE(measure_p95_error(test, reference, all));
  test.planes["visibility"][3] = 0.25f;
  EXPECT_NEAR(measure_p95_error(test, reference, all).value(), 0.75, 1e-6);
  reference.planes["visibility"][4] = 0.5f;
  test.planes["visibility"][4] = 1.0f;
  EXPECT_NEAR(measure_p95_error(test, reference, all).value(), 0.75, 1e-6);
}

TEST(P95Error, TwoStandardErrorsOfTheTruthAreNone) {
  const std::vector<uint8_t> all(40, 1);
  EXPECT_NEAR(measure_p95_error(row_of(40, 0.6f), row_of(40, 0.5f, 0.02f), all).value(), 0.06, 1e-6);
  EXPECT_EQ(measure_p95_error(row_of(40, 0.6f), row_of(40, 0.5f, 0.06f), all).value(), 0.0);
}

TEST(P95Error, LeavesOutWhatIsNotScored) {
  Image test = row_of(20, 0.5f);
  for (size_t i = 0; i < 10; ++i) test.planes["visibility"][i] = 1.0f;
  std::vector<uint8_t> mask(20, 1);
  EXPECT_NEAR(measure_p95_error(test, row_of(20, 0.5f), mask).value(), 0.5, 1e-7);
  for (size_t i = 0; i < 10; ++i) mask[i] = 0;
  EXPECT_EQ(measure_p95_error(test, row_of(20, 0.5f), mask).value(), 0.0);
  EXPECT_FALSE(measure_p95_error(test, row_of(20, 0.5f), std::vector<uint8_t>(20, 0)));
  EXPECT_THROW(measure_p95_error(test, row_of(19, 0.5f), mask), Error);
}

}  // namespace
}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
// Without these a broken error metric could be believed.

#include "metrics/metric_probe.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MetricProbe, TheRealMetricHasNoProblem) {
  EXPECT_THAT(metric_problems(error_metric), IsEmpty());
}

TEST(MetricProbe, AWrongNumberIsNamed) {
  const auto wrong = [](const Image& test, const Image& reference, std::span<const uint8_t> mask) {
    VisibilityError error = measure_visibility_error(test, reference, mask);
    error.bias = -*error.bias;
    return error;
  };
  EXPECT_THAT(metric_problems(wrong),
              ElementsAre("the error metric's bias of a known pair is -0.050000 instead of 0.05"));
}

TEST(MetricProbe, AbsentNumbersAndErrorsAreProblems) {
  const auto silent = [](const Image&, const Image&, std::span<const uint8_t>) { return VisibilityError{}; };
  EXPECT_THAT(metric_problems(silent), testing::Contains(HasSubstr("mse of a known pair is absent")));
  const auto failing = [](const Image&, const Image&, std::span<const uint8_t>) -> VisibilityError {
    fail_input("no");
  };
  EXPECT_THAT(metric_problems(failing), ElementsAre("the error metric fails: no"));
}

}  // namespace
}  // namespace umbrameter

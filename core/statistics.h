// SPDX-License-Identifier: Apache-2.0
#pragma once
// Statistics that several rooms need.

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace umbrameter {

/// The middle value of at least one; of an even number the mean of the middle two.
template <class T>
double median(std::vector<T> values) {
  UMBRAMETER_ASSERT(!values.empty(), "the median of nothing");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const double upper = static_cast<double>(*middle);
  if (values.size() % 2 == 1) return upper;
  return 0.5 * (upper + static_cast<double>(*std::max_element(values.begin(), middle)));
}

/// The same; absent for no values.
template <class T>
std::optional<double> median_if_any(std::vector<T> values) {
  return values.empty() ? std::nullopt : std::optional<double>(median(std::move(values)));
}

/// A normal distribution's sigma, for a median of |x| of 1.
inline constexpr double kSigmaPerMedian = 1.4826;

/// The root with its sign, for squares from which noise was taken and which may be below 0.
inline double signed_root(double value) {
  return std::copysign(std::sqrt(std::abs(value)), value);
}

}  // namespace umbrameter

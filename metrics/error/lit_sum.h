// SPDX-License-Identifier: Apache-2.0
#pragma once
// What several lights make together: the lit picture, the sum over lights of visibility times unshadowed irradiance, against
// the truth's sum of irradiance (metrics/error/lit_error.h).

#include "core/image.h"
#include "metrics/error/verdict.h"
#include "metrics/statistics/interval.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace umbrameter {

/// One light's part of a picture. Images of one size.
struct LitPart {
  const Image* truth = nullptr;
  std::span<const uint8_t> mask;  // its scored pixels
  const Image* before = nullptr;  // with the values as given
  const Image* after = nullptr;   // with the tuned ones
};

struct LitSum {
  std::string scene;  // whose lights; left to who asks
  size_t pixels = 0;
  /// RMSE of the sum; 1 is the root mean square of all the light without shadows. The truth's noise is taken out.
  Interval before, after;
  Comparison outcome = Comparison::cannot_tell;  // after against before, pixel paired with pixel
};

/// Where every light that reaches the pixel is scored there. Absent without such pixels. Error{input} as compare_runs().
std::optional<LitSum> measure_lit_sum(std::span<const LitPart> parts);

}  // namespace umbrameter

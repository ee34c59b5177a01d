// SPDX-License-Identifier: Apache-2.0
#pragma once
// What is seen of a shadow's error: that of the lit picture, visibility times unshadowed irradiance, against the truth's
// irradiance; and what even a perfect visibility gets wrong of it (docs/metrics.md). The truth's noise is taken out.

#include "metrics/error/visibility_error.h"

namespace umbrameter {

/// RMSE of V x E against S x E where `mask` is not 0, E the reference's unshadowed irradiance; 1 is the root mean square of
/// E itself: all of the light in the wrong place. Needs irradiance_half_a and irradiance_half_b of the reference. Absent
/// without pixels. Error{input} on size mismatch and missing channels.
std::optional<double> measure_lit_error(const Image& test, const Image& reference,
                                        std::span<const uint8_t> mask);

/// S - V of the truth itself, which no technique that gives V can mend.
struct ModelGap {
  double rmse = 0.0;      // of S - V over pixels
  double lit_rmse = 0.0;  // of the lit picture, as measure_lit_error gives it for a perfect V
};

/// Absent without pixels. Error{input} as above.
std::optional<ModelGap> measure_model_gap(const Image& reference, std::span<const uint8_t> mask);

}  // namespace umbrameter

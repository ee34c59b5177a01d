// SPDX-License-Identifier: Apache-2.0
#pragma once
// How wrong the worst pixels are, which a mean over all hides.

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// Root mean square of V - R over the hundredth of the scored pixels (at least one) where |V - R| is largest, the truth's noise
/// included. Needs `visibility` of both. Absent without a scored pixel. Error{input} on size mismatch and missing channels.
std::optional<double> measure_worst_pixels(const Image& test, const Image& reference,
                                           std::span<const uint8_t> mask);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// How wrong shadows are nearly everywhere: the error that one shaded pixel in twenty exceeds.

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// 95th percentile (nearest rank), over the scored pixels where V or R is below .99, of what |V - R| exceeds twice the truth's standard error by, 0 where it
/// does not; in [0,1]. Needs `visibility` of both, and `visibility_se` of the reference. Absent without such a pixel. Error{input}
/// on size mismatch and missing channels.
std::optional<double> measure_p95_error(const Image& test, const Image& reference,
                                        std::span<const uint8_t> mask);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What shows where one shadow map ends and the next begins: cascades, faces of a cube.

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// Mean step |e_j - e_i| of the error e = V - R between neighbouring pixels i and j of one surface that are looked up in
/// different maps, less the mean of the same step one pixel before and after each such pair, where both pixels are looked up in
/// one map. So the truth's own step counts for nothing, nor do edges that any map has; the truth's noise cancels on average.
/// 0: no seam; a little below 0 by chance. Needs `visibility` of both, `map_index` of `test` (core/renderer.h), and the
/// reference's surfaces. Absent where `test` has no map_index or no such pairs are scored. Error{input} on size mismatch and
/// missing channels.
std::optional<double> measure_map_seam(const Image& test, const Image& reference,
                                       std::span<const uint8_t> mask);

}  // namespace umbrameter

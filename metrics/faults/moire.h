// SPDX-License-Identifier: Apache-2.0
#pragma once
// The frequency of acne's stripes: moire of the shadow map shows as one line in the spectrum, at one cycle a
// texel. Ours (METRICS 6.7).

#include "metrics/faults/faults.h"

#include <optional>

namespace umbrameter {

/// Medians over tiles of 32 x 32 px with acne and a peak that noise would hardly show; absent without such a
/// tile, which is "not identifiable".
struct Moire {
  size_t tiles = 0;  // with a peak
  std::optional<double> cycles_per_px;
  /// Absent, too, where texels are not known, or smaller than two pixels (samples alias) or larger than eight.
  std::optional<double> cycles_per_texel;
};

/// Of the error on the pixels that `faults` calls acne. Needs visibility and, for the texels, texel.x, texel.y
/// and texel_world of `test`; visibility, position, normal and primitive_id of `reference`. At most 512 tiles
/// are looked at, evenly spread.
Moire measure_moire(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                    const Faults& faults);

}  // namespace umbrameter

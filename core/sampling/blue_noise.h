// SPDX-License-Identifier: Apache-2.0
#pragma once
// A square of ranks without low frequencies, for taps that differ from pixel to pixel.

#include <cstdint>
#include <vector>

namespace umbrameter {

inline constexpr uint32_t kBlueNoiseSide = 64;

/// Each rank from 0 to side^2 - 1 once, by rows; the square repeats without seams. Those below any rank lie as far apart as so
/// many can. Void-and-cluster (Ulichney, The void-and-cluster method for dither array generation, SPIE 1913, 1993) with his
/// Gaussian of 1.5 px. Always the same ranks: distances are weighed in whole numbers. `side` is even, at least 8.
std::vector<uint32_t> blue_noise_ranks(uint32_t side = kBlueNoiseSide);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Does a reference contradict itself? What can be told of it without another reference.

#include "core/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct TruthSettings {
  /// (A - B)^2 over 4 se^2, summed over pixels whose samples do not all agree, is about 1 when the halves are
  /// independent: 8 replicates measure both.
  double least_spread_ratio = 0.5, largest_spread_ratio = 2.0;
  size_t fewest_pixels = 50;
  /// Edges from full light to full shadow between neighbours for which there is no pixel in between.
  size_t sharp_edges = 50;
  double partial_per_edge = 0.1;
};

/// One sentence for everything that cannot be: halves that are not independent, an area light without penumbra.
/// Needs visibility, visibility_se, half_a and half_b of the reference. Error{input} on missing channels.
std::vector<std::string> truth_problems(const Image& reference, std::span<const uint8_t> mask,
                                        const TruthSettings& settings = {});

}  // namespace umbrameter

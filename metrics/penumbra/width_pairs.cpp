// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/width_pairs.h"

#include "metrics/penumbra/penumbra.h"

#include <algorithm>

namespace umbrameter {

std::vector<WidthPair> measure_width_pairs(const Image& test, const Image& reference,
                                           std::span<const uint8_t> mask) {
  std::vector<WidthPair> pairs;
  for (const PenumbraProfile& profile : measure_penumbra(test, reference, mask).profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    pairs.push_back({profile.reference_width_world, profile.test_width_world});
  }
  std::ranges::stable_sort(pairs, {}, &WidthPair::reference_world);
  return pairs;
}

}  // namespace umbrameter

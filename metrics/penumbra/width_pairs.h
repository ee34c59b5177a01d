// SPDX-License-Identifier: Apache-2.0
#pragma once
// The points of the contact-hardening plot. Not here: the line through them (metrics/penumbra/contact_hardening.h).

#include "core/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// Penumbra widths of one accepted profile, in world units.
struct WidthPair {
  double reference_world = 0.0;
  double test_world = 0.0;
};

/// Of all accepted profiles, by the reference's width. Needs what measure_penumbra needs.
std::vector<WidthPair> measure_width_pairs(const Image& test, const Image& reference,
                                           std::span<const uint8_t> mask);

}  // namespace umbrameter

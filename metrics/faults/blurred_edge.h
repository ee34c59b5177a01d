// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether an error is the blur of a true edge: too dark in its light and too bright in its shadow, by a filter wider
// than the penumbra. Ours; over-blur is told from acne, leaks and peter-panning by it.

#include "metrics/image/standing_alone.h"

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

/// Whether the test falls (dark) or rises (bright) all the straight way from pixel `i` to the pixel `edge` of a true edge,
/// stands between light and shadow there, and goes on to err the other way within twice as far behind it. Where the surface ends
/// behind the edge, as at a contact, the way to it alone decides. A shadow that is thinner than the filter may be almost gone on
/// its edge: where the shade around `is_kept`, no more than `tolerance`, that of errors, must be left. Linear in the distance.
bool is_blurred_edge(const Outskirts& field, size_t i, size_t edge, float tolerance, bool is_kept = false);

/// The truth as a Gaussian blur of the picture that explains the test best: no more than .35 of the mean |V - R| is left.
/// Empty when none does. Judged over scored pixels (`mask`); blurred over `seen` ones, which show a surface, lit or not.
std::vector<float> blurred_as_picture(std::span<const float> v, std::span<const float> r,
                                      std::span<const uint8_t> mask, std::span<const uint8_t> seen, int width,
                                      int height);

}  // namespace umbrameter

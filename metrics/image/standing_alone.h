// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether a pixel's error may be a true penumbra that is wider or lies elsewhere. Such a penumbra gets no lighter towards
// its shadow, so light between the two says no; and a shadow does not creep over an outline, so shade on another surface
// says no, too. Ours; acne and leaks beside shadows are told by it.

#include "metrics/image/surface.h"

#include <cstdint>
#include <span>

namespace umbrameter {

/// One direction of errors, by which all values are multiplied: 1 too dark, -1 too bright.
struct Outskirts {
  std::span<const float> v, r;
  std::span<const uint8_t> mask;
  SurfaceView surface;
  float sign = 1.0f;

  /// Whether the truth at pixel `i` is fully lit (dark) or fully shadowed (bright) up to `epsilon`.
  bool on_plateau(size_t i, float epsilon) const {
    return sign > 0.0f ? r[i] > 1.0f - epsilon : r[i] < epsilon;
  }
};

/// True when from pixel `i` no straight way of up to `reach_px` leads to a truth as dark as the pixel, `tolerance` forgiven,
/// without the test rising on it or, for too dark ones, the surface ending. Linear in `reach_px`, and short where the pixel does stand alone.
bool stands_alone(const Outskirts& field, size_t i, double reach_px, float tolerance);

}  // namespace umbrameter

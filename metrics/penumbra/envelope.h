// SPDX-License-Identifier: Apache-2.0
#pragma once
// What no small shift or width error of a true penumbra explains: the envelope residual (METRICS 5c). Ours;
// the base of acne and leak detection (metrics/faults/faults.h).

#include "metrics/error/visibility_error.h"
#include "metrics/penumbra/penumbra.h"

#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

struct EnvelopeSettings {
  double radius_per_width = 0.15;     // of the nearest penumbra's width; .1 to .25 tell the same
  double tolerance = 0.02;            // or 3 standard errors of the reference, if more
  double max_width_px = 512.0;        // of a penumbra, for the radius
  VisibilityErrorSettings bootstrap;  // tile_px, bootstrap_rounds, seed
};

/// r = 1 px + radius_per_width * (width of the nearest penumbra); low and high are the least and greatest
/// visibility of scored reference pixels within r. Where full light (full shadow) stands alone (metrics/image/standing_alone.h)
/// its own value is low (high): light between a dark pixel and its shadow is no wider penumbra.
struct Envelope {
  int width = 0, height = 0;
  std::vector<float> dark;               // [height][width] max(0, low - V - tolerance)
  std::vector<float> bright;             // [height][width] max(0, V - high - tolerance)
  std::vector<float> tolerance;          // [height][width] that was allowed
  std::vector<int32_t> nearest_profile;  // [height][width] index into the profiles, -1 without any
  size_t scored_pixels = 0, dark_pixels = 0, bright_pixels = 0;
  std::optional<Interval> mean_dark, mean_bright;  // over scored pixels; absent without any
};

/// `profiles` are those measure_penumbra found, rejected ones too: their reference width still tells the
/// scale. Needs visibility in both and visibility_se in the reference. Time grows with the radius only where
/// the error exceeds the tolerance, linearly. Error{input} on size mismatch, missing channels, NaN, values
/// outside [0,1].
Envelope measure_envelope(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                          std::span<const PenumbraProfile> profiles, const EnvelopeSettings& settings = {});

}  // namespace umbrameter

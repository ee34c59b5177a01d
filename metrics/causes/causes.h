// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which part of an error the map's resolution, its steps and a technique's noise explain (METRICS 6.10, 6.12).
// Ours, but for the texel's footprint, which is Lloyd's m (2006).

#include "metrics/penumbra/penumbra.h"

#include <array>
#include <optional>
#include <span>

namespace umbrameter {

/// Lower ends of the bins of a texel's longest extent in pixels; the last bin has no upper end.
inline constexpr std::array<double, 6> kFootprintBinsPx = {0.0, 0.5, 1.0, 2.0, 4.0, 8.0};

struct FootprintBin {
  size_t pixels = 0;
  double mean_abs_error = 0.0;  // sum |V - R| over its pixels, over all scored pixels
};

/// Absent: not applicable.
struct ErrorCauses {
  size_t scored_pixels = 0;
  /// By footprint; `unknown` are pixels without a map or beside no other of their surface. The parts add up to
  /// the image's mean absolute error.
  std::array<FootprintBin, kFootprintBinsPx.size()> by_footprint{};
  FootprintBin unknown;
  std::optional<double> mean_abs_error;
  std::optional<double> median_footprint_px;

  /// Standard deviation of the edge's offset against its neighbours' along the contour, in texels facing the
  /// light, where a texel is 2 px or more. A hard map's stairs have .29 (1 / sqrt 12).
  std::optional<double> stair_texels;
  size_t stair_profiles = 0;

  /// 1 - distinct levels / pixels, median over penumbrae of 8 px or more: 0 = smooth, near 1 = hard.
  std::optional<double> banding;
  std::optional<double> levels;  // the median itself
  size_t banding_profiles = 0;

  /// Median distance from the 3 x 3 mean, as a standard deviation, where .05 < R < .95. Steps of hard edges
  /// are few and do not count.
  std::optional<double> noise, reference_noise;
};

/// `profiles` are those of the same pair and mask. Needs visibility in both; position, normal and primitive_id
/// in the reference; the texel parts need texel.x, texel.y and texel_world of the test. Error{input} on size
/// mismatch, missing channels, NaN, values outside [0,1].
ErrorCauses measure_causes(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                           std::span<const PenumbraProfile> profiles);

}  // namespace umbrameter

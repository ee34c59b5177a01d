// SPDX-License-Identifier: Apache-2.0
#pragma once
// FLIP, SSIM and PSNR of the lit picture: second opinions, on which no verdict rests (docs/metrics.md).

#include "core/image.h"
#include "metrics/flip/flip.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// The whole picture counts; what is not scored is black in both. All absent for an empty picture, HDR-FLIP also for a
/// black truth, SSIM also for one smaller than its window.
struct Similarity {
  double pixels_per_degree = 0.0;
  std::optional<double> flip_mean, flip_p99, flip_share_above_02;
  std::optional<double> hdr_flip_mean, hdr_flip_p99;
  std::optional<double> ssim;
  std::optional<double> psnr_db;  // infinite for equal pictures
};

/// What a white diffuse surface sends back: V times the truth's unshadowed irradiance over its largest scored one, in
/// [0,1], linear; 0 where `mask` is. Error{input} for missing channels, NaN and values out of range.
std::vector<float> lit_plane(const Image& image, const Image& reference, std::span<const uint8_t> mask);

/// The truth's lit picture and FLIP's view of it, made once for any number of tests with one mask. Keeps 25 bytes a pixel
/// and 12 more an exposure of HDR-FLIP.
class SimilarityReference {
 public:
  /// Errors as lit_plane.
  SimilarityReference(const Image& reference, std::span<const uint8_t> mask);
  std::span<const uint8_t> mask() const { return mask_; }
  /// LDR-FLIP, SSIM and PSNR of the sRGB-encoded lit picture, HDR-FLIP of the linear one. `maps`, if given, gets the
  /// plane flip. Errors as lit_plane.
  Similarity measure(const Image& test, Image* maps = nullptr) const;

 private:
  std::vector<uint8_t> mask_;
  std::vector<float> gain_;  // what light there is, over the most; 0 where unscored
  Image lit_;
  FlipReference flip_;
  HdrFlipReference hdr_flip_;
};

/// SimilarityReference for a single test.
Similarity measure_similarity(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                              Image* maps = nullptr);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// How different two pictures look when flipped between: LDR-FLIP (Andersson, Nilsson, Akenine-Moller,
// Oskarsson, Astrom, Fairchild 2020, "FLIP: A difference evaluator for alternating images", HPG) and HDR-FLIP
// (Andersson, Nilsson, Shirley, Akenine-Moller 2021, "Visualizing errors in rendered high dynamic range
// images", Eurographics). A second opinion on the lit picture, not a measure of shadows: its mean cannot tell
// a leak from a benign change (METRICS 5b).

#include "core/image.h"
#include "metrics/flip/flip_map.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Red, green, blue: names of planes. Grey: one name thrice.
using ColorChannels = std::array<std::string, 3>;

struct FlipSettings {
  double pixels_per_degree = 67.0206;  // 3840 px over .7 m, seen from .7 m: the paper's default
};

struct Flip {
  std::vector<float> map;  // [height][width] in [0,1], 0 = equal
  double mean = 0.0;
  double p99 = 0.0;
  double share_above_02 = 0.0;  // of pixels
};

/// The reference's side of LDR-FLIP, which costs as much as the test's: made once for any number of tests. Keeps 12 bytes
/// a pixel of grey pictures, 20 of others.
class FlipReference {
 public:
  /// `reference` holds sRGB-encoded display values in [0,1]. Error{input} on missing channels, NaN, values outside [0,1].
  FlipReference(const Image& reference, ColorChannels channels, const FlipSettings& settings = {});
  /// Absent for an empty picture. Errors as above, and on size mismatch.
  std::optional<Flip> measure(const Image& test) const;

 private:
  ColorChannels channels_;
  FlipSettings settings_;
  SeenPicture seen_;
};

/// FlipReference for a single test.
std::optional<Flip> measure_flip(const Image& test, const Image& reference, const ColorChannels& channels,
                                 const FlipSettings& settings = {});

/// Exposures in stops: start, stop and `count` of them at even steps, both ends included.
struct ExposureRange {
  double start = 0.0;
  double stop = 0.0;
  int count = 0;
};

/// HDR-FLIP's range: the ACES curve brings the reference's largest luminance to .85 at `start` and its median to
/// .85 at `stop`; at least two exposures, at most one stop apart. Our addition: the median is of pixels that are not
/// black. Absent when all are.
std::optional<ExposureRange> exposure_range(const Image& reference, const ColorChannels& channels);

/// The ACES curve of HDR-FLIP (Narkowicz's fit without its exposure), before clamping to [0,1].
float aces_tone(float linear);

/// The same of HDR-FLIP, for linear BT.709 values of 0 or more; keeps as much once an exposure.
class HdrFlipReference {
 public:
  HdrFlipReference(const Image& reference, ColorChannels channels, const FlipSettings& settings = {});
  /// Pixel by pixel the largest LDR-FLIP over the exposures. Absent for an empty picture and a black reference.
  std::optional<Flip> measure(const Image& test) const;

 private:
  struct Exposed {
    double stops = 0.0;
    SeenPicture seen;
  };
  ColorChannels channels_;
  FlipSettings settings_;
  int width_ = 0, height_ = 0;
  std::vector<Exposed> exposures_;
};

/// HdrFlipReference for a single test.
std::optional<Flip> measure_hdr_flip(const Image& test, const Image& reference, const ColorChannels& channels,
                                     const FlipSettings& settings = {});

}  // namespace umbrameter

#pragma once
// How different two pictures look when flipped between: LDR-FLIP (Andersson, Nilsson, Akenine-Moller,
// Oskarsson, Astrom, Fairchild 2020, "FLIP: A difference evaluator for alternating images", HPG). A second
// opinion on the lit picture, not a measure of shadows: its mean cannot tell a leak from a benign change
// (METRICS 5b).

#include "core/image.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Red, green, blue: names of planes with sRGB-encoded display values in [0,1]. Grey: one name thrice.
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

/// Absent for an empty picture. Error{input} on size mismatch, missing channels, NaN, values outside [0,1].
std::optional<Flip> measure_flip(const Image& test, const Image& reference, const ColorChannels& channels,
                                 const FlipSettings& settings = {});

}  // namespace umbrameter

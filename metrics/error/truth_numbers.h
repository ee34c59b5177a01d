// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a regression remembers of a scene's truth: enough to notice that another truth is being compared with, without
// keeping its picture.

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace umbrameter {

struct MeanWithNoise {
  double value = 0.0;
  double sd = 0.0;  // of the samples
};

/// Over pixels that hit something. The second mean is V (1 - V) without the noise's part: how much penumbra there is.
struct TruthNumbers {
  std::string hash;  // of visibility: the same request gives it again, bit for bit, on one machine
  std::string device;
  uint64_t seed = 0;
  double samples_per_pixel = 0.0;
  MeanWithNoise visibility, penumbra;
};

TruthNumbers truth_numbers(const Image& truth, const std::string& device, uint64_t seed);

/// What tells the two truths apart beyond `sigmas` of their noise; absent when nothing does.
std::optional<std::string> truth_difference(const TruthNumbers& now, const TruthNumbers& before,
                                            double sigmas);

/// The mean of two truths of one picture with independent samples, each pixel weighted by their number. Everything but
/// visibility, its halves, its error and the number of samples stays as in `truth`.
void add_samples(Image& truth, const Image& more);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which pixels are wrong beyond the reference's noise (METRICS 6.3).

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

struct SignificanceSettings {
  /// v0: the square of what nobody calls an error. A thousandth of the light, a quarter of an 8-bit step.
  double floor_variance = 1e-6;
  /// How many independent estimates visibility_se was taken from, 2 or more.
  int replicates = 8;
  /// Expected share of false ones among the pixels called wrong.
  double false_discovery_rate = 0.05;
  /// abs(z) beyond which pixels are counted against the binomial expectation.
  double exceedance_z = 3.0;
};

/// The optionals are absent when no pixel was tested, threshold_z also when no pixel is wrong.
struct Significance {
  size_t tested = 0;
  size_t too_dark = 0, too_bright = 0;       // pixels called wrong, by sign
  std::optional<double> threshold_z;         // of abs(z), by Benjamini and Hochberg
  size_t exceeding = 0;                      // pixels with abs(z) > exceedance_z
  std::optional<double> expected_exceeding;  // if all were right
  std::optional<double> exceedance_sigmas;   // excess over it in binomial standard deviations
  std::vector<float> z;                      // [height][width], 0 where not tested
  std::vector<uint8_t> wrong;                // [height][width], 1 = called wrong

  size_t significant() const { return too_dark + too_bright; }
};

/// z of one pixel: standard normal when v is the truth. `r` and its standard error come from `replicates`
/// estimates, so (v - r) / sqrt(se^2 + test_se^2 + v0) has Student's distribution, which Wallace's transformation
/// takes to the normal. Where all samples agree (r is 0 or 1) the replicates have no spread and se is .5 / samples:
/// there the variance is that of Wilson's score, v (1 - v) / samples.
double normal_deviate(double v, double r, double se, double test_se, const SignificanceSettings& settings);

/// Tests `visibility` of `test` (and its visibility_se, if it has one) against `visibility` and `visibility_se` of
/// `reference` where `mask` is not 0. Error{input} on size mismatch, missing channels, NaN (with its pixel) and
/// values out of range.
Significance measure_significance(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                                  const SignificanceSettings& settings = {});

}  // namespace umbrameter

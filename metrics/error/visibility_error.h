// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far a technique's visibility is from the truth, with the truth's own noise taken out
// (METRICS 6.2, 6.4).

#include "core/image.h"
#include "metrics/statistics/interval.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace umbrameter {

enum class Region : uint8_t { lit, umbra, penumbra };

/// Sums over one region; `share` weighs it, so that sum(share * mse) over regions is the total mse.
struct RegionError {
  size_t pixels = 0;
  double share = 0.0;  // of scored pixels
  double mse = 0.0;    // noise-debiased
  double bias = 0.0;   // mean(V - R)
};

/// Absent fields mean "not applicable": there was nothing to measure.
struct VisibilityError {
  size_t scored_pixels = 0;
  std::optional<Interval> mse;            // mean (V - A)(V - B): unbiased, may be slightly negative
  std::optional<Interval> rmse;           // sign(mse) sqrt|mse|, interval mapped the same way
  std::optional<double> mae;              // mean |V - R|; includes the reference's noise
  std::optional<double> bias;             // mean (V - R)
  std::optional<double> over_shadowing;   // mean max(0, R - V)
  std::optional<double> under_shadowing;  // mean max(0, V - R)
  std::optional<double> noise_floor_mse;  // mean visibility_se^2: what MAE-like numbers cannot resolve below
  std::optional<double> max_error;        // max |V - R|
  RegionError lit, umbra, penumbra;
  std::optional<double> mse_noise_sd;  // of `mse`, from the reference's samples alone
};

struct VisibilityErrorSettings {
  double region_epsilon = 0.01;  // lit: R > 1 - e, umbra: R < e
  int tile_px = 32;              // bootstrap unit: errors are correlated within a filter's reach
  int bootstrap_rounds = 1000;
  uint64_t seed = 1;
};

/// Compares `visibility` of `test` with visibility, half_a, half_b and visibility_se of `reference` where
/// `mask` is not 0. Error{input} on size mismatch, missing channels, NaN (with its pixel), or values outside
/// [0,1].
VisibilityError measure_visibility_error(const Image& test, const Image& reference,
                                         std::span<const uint8_t> mask,
                                         const VisibilityErrorSettings& settings = {});

}  // namespace umbrameter

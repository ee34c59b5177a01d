// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether an image's errors stand out from the reference's noise: pixel by pixel, against another image and against
// a limit (docs/metrics.md). Not here: how large they are (lab/score.h) and why (metrics/diagnosis.h).

#include "core/image.h"
#include "metrics/error/verdict.h"
#include "metrics/statistics/significance.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace umbrameter {

/// Significance without its maps.
struct SignificanceNumbers {
  size_t tested = 0;
  size_t too_dark = 0, too_bright = 0;
  std::optional<double> threshold_z;
  size_t exceeding = 0;
  std::optional<double> expected_exceeding;
  std::optional<double> exceedance_sigmas;
};

SignificanceNumbers significance_numbers(const Significance& significance);

/// `more_samples`: how many more samples a pixel would decide; absent when decided, and when no number would.
struct RunVerdict {
  std::string baseline;
  Comparison outcome = Comparison::cannot_tell;
  Interval mse_difference;  // this image less the baseline
  std::optional<double> more_samples;
};

struct LimitNumbers {
  double limit_rmse = 0.0;
  LimitOutcome outcome = LimitOutcome::cannot_tell;
  std::optional<double> more_samples;
};

struct Judgement {
  std::optional<SignificanceNumbers> significance;
  std::optional<RunVerdict> verdict;
  std::optional<LimitNumbers> limit;
};

/// An image with the pixels it is scored on.
struct ScoredImage {
  const Image& image;
  std::span<const uint8_t> mask;
};

/// On the pixels that count for both; absent without any. `reference` has sample_count, too.
std::optional<RunVerdict> judge_against(const ScoredImage& candidate, const ScoredImage& baseline,
                                        const std::string& baseline_name, const Image& reference);

/// The same of two runs' pictures, each of which says what it is (metrics/image/shadow_quantity.h), against `reference` as rendered.
/// Absent, too, where they are of different quantities: their errors are not of one kind.
std::optional<RunVerdict> judge_runs(const ScoredImage& candidate, const ScoredImage& baseline,
                                     const std::string& baseline_name, const Image& reference);

std::optional<LimitNumbers> judge_against(double limit_rmse, const VisibilityError& error,
                                          const Image& reference, std::span<const uint8_t> mask);

}  // namespace umbrameter

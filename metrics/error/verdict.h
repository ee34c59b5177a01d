// SPDX-License-Identifier: Apache-2.0
#pragma once
// Does a difference stand out from the noise, and if not, would more samples show it? (METRICS 6.2)

#include "core/image.h"
#include "metrics/error/visibility_error.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace umbrameter {

enum class Comparison : uint8_t { better, worse, same, cannot_tell };
std::string_view name_of(Comparison outcome);

enum class LimitOutcome : uint8_t { pass, fail, cannot_tell };
std::string_view name_of(LimitOutcome outcome);

struct ComparisonVerdict {
  Comparison outcome = Comparison::cannot_tell;
  Interval mse_difference;   // candidate less baseline
  double same_within = 0.0;  // of mse_difference
  /// How many times the reference's samples would decide; absent when decided, and when no number would: the spread
  /// from place to place is too large, so other views would.
  std::optional<double> sample_factor;
};

struct LimitVerdict {
  LimitOutcome outcome = LimitOutcome::cannot_tell;
  std::optional<double> sample_factor;  // likewise
};

struct VerdictSettings {
  double same_share = 0.05;  // mean squared errors this close to the baseline's are the same
  int tile_px = 32;
  int bootstrap_rounds = 1000;
  uint64_t seed = 1;
};

/// Which of two images is nearer to the truth, pixel paired with pixel. Absent when `mask` is empty. Error{input} as
/// measure_visibility_error.
std::optional<ComparisonVerdict> compare_runs(const Image& candidate, const Image& baseline,
                                              const Image& reference, std::span<const uint8_t> mask,
                                              const VerdictSettings& settings = {});

/// pass: the 95 % interval of the RMSE lies at or below `limit_rmse` > 0; fail: above it. Absent without scored pixels.
std::optional<LimitVerdict> judge_limit(const VisibilityError& error, double limit_rmse);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "metrics/judgement.h"

#include "metrics/image/shadow_quantity.h"

namespace umbrameter {
namespace {

std::optional<double> more_samples(const std::optional<double>& factor, const Image& reference,
                                   std::span<const uint8_t> mask) {
  if (!factor) return std::nullopt;
  const std::span<const float> samples = reference.plane("sample_count");
  double sum = 0.0, pixels = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    sum += static_cast<double>(samples[i]);
    pixels += 1.0;
  }
  return (*factor - 1.0) * sum / pixels;
}

}  // namespace

SignificanceNumbers significance_numbers(const Significance& significance) {
  return {significance.tested,           significance.too_dark,  significance.too_bright,
          significance.threshold_z,      significance.exceeding, significance.expected_exceeding,
          significance.exceedance_sigmas};
}

std::optional<RunVerdict> judge_against(const ScoredImage& candidate, const ScoredImage& baseline,
                                        const std::string& baseline_name, const Image& reference) {
  std::vector<uint8_t> both(candidate.mask.begin(), candidate.mask.end());
  for (size_t i = 0; i < both.size(); ++i) both[i] = both[i] != 0 && baseline.mask[i] != 0 ? 1 : 0;
  const auto verdict = compare_runs(candidate.image, baseline.image, reference, both);
  if (!verdict) return std::nullopt;
  return RunVerdict{baseline_name, verdict->outcome, verdict->mse_difference,
                    more_samples(verdict->sample_factor, reference, both)};
}

std::optional<RunVerdict> judge_runs(const ScoredImage& candidate, const ScoredImage& baseline,
                                     const std::string& baseline_name, const Image& reference) {
  if (quantity_of(candidate.image) != quantity_of(baseline.image)) return std::nullopt;
  std::optional<Image> made;
  return judge_against(candidate, baseline, baseline_name, truth_for(candidate.image, reference, made));
}

std::optional<LimitNumbers> judge_against(double limit_rmse, const VisibilityError& error,
                                          const Image& reference, std::span<const uint8_t> mask) {
  const auto verdict = judge_limit(error, limit_rmse);
  if (!verdict) return std::nullopt;
  return LimitNumbers{limit_rmse, verdict->outcome, more_samples(verdict->sample_factor, reference, mask)};
}

}  // namespace umbrameter

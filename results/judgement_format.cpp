// SPDX-License-Identifier: Apache-2.0
#include "results/judgement_format.h"

#include "results/format.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

std::string wrong_pixels_text(const SignificanceNumbers& numbers) {
  if (numbers.tested == 0) return kNotApplicable;
  if (!numbers.threshold_z) return fmt::format("none of {} stands out from the noise", numbers.tested);
  return fmt::format("{} of {} stand out from the noise, from {:.1f} sigmas on: {} too dark, {} too bright",
                     numbers.too_dark + numbers.too_bright, numbers.tested, *numbers.threshold_z,
                     numbers.too_dark, numbers.too_bright);
}

std::string exceedance_text(const SignificanceNumbers& numbers) {
  if (!numbers.expected_exceeding) return kNotApplicable;
  return fmt::format("{} pixels; noise alone would give {:.0f}", numbers.exceeding,
                     *numbers.expected_exceeding);
}

std::string what_would_decide(const std::optional<double>& more_samples) {
  if (!more_samples) return "; more samples would not decide, other views may";
  return fmt::format("; about {:.0f} more samples per pixel would decide", std::max(1.0, *more_samples));
}

}  // namespace

std::string format_verdict(const std::optional<RunVerdict>& verdict) {
  if (!verdict) return kNotApplicable;
  std::string text(name_of(verdict->outcome));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string verdict_line(const RunVerdict& verdict) {
  std::string text = fmt::format("against {}: {}, mean squared error {:+.2e} [{:+.2e}, {:+.2e}]",
                                 verdict.baseline, format_verdict(verdict), verdict.mse_difference.value,
                                 verdict.mse_difference.low, verdict.mse_difference.high);
  return verdict.outcome == Comparison::cannot_tell ? text + what_would_decide(verdict.more_samples) : text;
}

std::string limit_line(const LimitNumbers& limit) {
  const std::string text = fmt::format("RMSE {}: ", limit.limit_rmse);
  if (limit.outcome != LimitOutcome::cannot_tell) return text + std::string(name_of(limit.outcome));
  return text + "cannot tell" + what_would_decide(limit.more_samples);
}

TermLines judgement_lines(const Judgement& judgement) {
  TermLines lines;
  if (judgement.significance) {
    lines.emplace_back("wrong pixels", wrong_pixels_text(*judgement.significance));
    lines.emplace_back("beyond 3 sigmas", exceedance_text(*judgement.significance));
  }
  if (judgement.verdict) lines.emplace_back("verdict", verdict_line(*judgement.verdict));
  if (judgement.limit) lines.emplace_back("limit", limit_line(*judgement.limit));
  return lines;
}

}  // namespace umbrameter

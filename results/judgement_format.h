// SPDX-License-Identifier: Apache-2.0
#pragma once
// A judgement as people read it; the terminal and the report show the same text.

#include "metrics/judgement.h"
#include "results/diagnosis_format.h"

#include <optional>
#include <string>

namespace umbrameter {

/// "better", "worse", "same" or "cannot tell"; "n/a" without a verdict.
std::string format_verdict(const std::optional<RunVerdict>& verdict);

/// The verdict with its baseline and interval, and what would decide it.
std::string verdict_line(const RunVerdict& verdict);
/// Pass, fail or cannot tell, and what would decide it.
std::string limit_line(const LimitNumbers& limit);

/// Wrong pixels, what exceeds the noise, the verdict and the limit: those that there are.
TermLines judgement_lines(const Judgement& judgement);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rule of a regression: a run's numbers against the baseline's, against truth both (docs/regress.md). Not here: where
// numbers come from (study/regress/run.h).

#include "results/regress/outcome.h"
#include "study/regress/suite_file.h"

#include <optional>
#include <string>

namespace umbrameter {

/// By the gate first, then the limits, then the ratchet. Frame times are judged by judge_time.
CaseVerdict judge_case(const CaseNumbers& now, const CaseNumbers& before, const RegressGates& gates);

/// Fails when the time's lower end is above the ratio times the baseline's upper end, each three robust standard
/// deviations of its median wide. Absent when it passes.
std::optional<CaseVerdict> judge_time(const BaselineTime& now, const BaselineTime& before, double ratio);

}  // namespace umbrameter

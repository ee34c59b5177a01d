// SPDX-License-Identifier: Apache-2.0
#pragma once
// From what a regression measured to the baseline that it is compared with next.

#include "results/regress/outcome.h"

namespace umbrameter {

/// What was measured, as a baseline with one reason.
Baseline baseline_of(const RegressResults& measured, const BaselineReason& reason);

/// Takes over what the check found to be neither the same nor void: failures, improvements, new cases, other parameters; drops stale ones.
/// `measured` has those scenes and runs as measure_suite gives them. The reason names what changed.
Baseline updated(const Baseline& baseline, const RegressResults& checked, const RegressResults& measured,
                 BaselineReason reason);

}  // namespace umbrameter

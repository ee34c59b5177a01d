// SPDX-License-Identifier: Apache-2.0
#pragma once
// What tuning found, as text for the terminal.

#include "study/tune/lit_sum.h"

#include <string>
#include <vector>

namespace umbrameter {

/// A ranked table of the tuned values beside defaults and presets, the values, windows and sensitivities.
std::string tune_text(const TunePlan& plan, const TuneResult& result);

/// A line a scene: the lit picture before and after, and which is nearer to the truth.
std::string lit_sum_text(const std::vector<LitSum>& sums);

}  // namespace umbrameter

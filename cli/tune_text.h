// SPDX-License-Identifier: Apache-2.0
#pragma once
// What tuning found, as text for the terminal.

#include "study/tune/tune.h"

#include <string>

namespace umbrameter {

/// A ranked table of the tuned values beside defaults and presets, the values, windows and sensitivities.
std::string tune_text(const TunePlan& plan, const TuneResult& result);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The per-run guard: one run of many may fail; it is recorded and the rest goes on.

#include "results/results.h"

#include <functional>
#include <optional>

namespace umbrameter {

/// Runs `work`; what it threw as a Failure, nothing when it succeeded. Error{cancelled} passes through.
std::optional<Failure> guarded(const std::function<void()>& work);

}  // namespace umbrameter

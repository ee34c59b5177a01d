// SPDX-License-Identifier: Apache-2.0
#pragma once
// The per-run guard: one run of many may fail; it is recorded and the rest goes on.

#include "core/error.h"

#include <functional>
#include <optional>
#include <string>

namespace umbrameter {

/// Why a run has no result: the text and kind of the Error it ended with.
struct Failure {
  ErrorKind kind = ErrorKind::internal;
  std::string message;
};

/// Runs `work`; what it threw as a Failure, nothing when it succeeded. Error{cancelled} passes through.
std::optional<Failure> guarded(const std::function<void()>& work);

}  // namespace umbrameter

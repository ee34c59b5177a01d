// SPDX-License-Identifier: Apache-2.0
#pragma once
// A pass's fixed-function state in GL's words.

#include "realtime/executor/plan.h"

namespace umbrameter {

/// Sets what differs from set_default_state() (realtime/harness/draw.h), which must have been called; after clearing, because
/// masks hold back clears too.
void set_pass_state(const PassDeclaration& pass, const Step& step);

}  // namespace umbrameter

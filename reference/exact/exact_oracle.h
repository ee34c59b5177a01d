// SPDX-License-Identifier: Apache-2.0
#pragma once
// The oracle inside this process: for the program `umbrameter-exact` and for tests.

#include "reference/exact_answer.h"

namespace umbrameter {

/// exact_light() of every receiver.
ExactOracle exact_oracle();

}  // namespace umbrameter

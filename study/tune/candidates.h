// SPDX-License-Identifier: Apache-2.0
#pragma once
// What tuned values compete with: the defaults and every preset, at the same cost and as given.

#include "study/tune/tune.h"

#include <vector>

namespace umbrameter {

/// The defaults first. A preset's costs (taps, map size, and what a tuner may not change) are left out unless they are
/// tuned; where it sets some, it also competes with its own. Equal ones are one candidate of several names.
std::vector<Candidate> make_candidates(const TunePlan& plan, const SearchSpace& space);

}  // namespace umbrameter

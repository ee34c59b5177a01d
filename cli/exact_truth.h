// SPDX-License-Identifier: Apache-2.0
#pragma once
// Exact visibilities for study/stress.

#include "lab/truth_oracle.h"
#include "reference/exact_answer.h"

namespace umbrameter {

/// `oracle` asked, exact for rectangles over a few hundred triangles; says nothing of other scenes. Triangles in the
/// receiver's own plane, as far as floats can tell, block nothing.
TruthOracle exact_truth(const ExactOracle& oracle);

}  // namespace umbrameter

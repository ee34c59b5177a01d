// SPDX-License-Identifier: Apache-2.0
#pragma once
// Exact visibilities for study/stress, from the CGAL oracle.

#include "study/stress/truth_check.h"

namespace umbrameter {

/// Exact for rectangles over a few hundred triangles; says nothing of other scenes. Triangles in the receiver's own plane,
/// as far as floats can tell, block nothing.
TruthOracle exact_oracle();

}  // namespace umbrameter

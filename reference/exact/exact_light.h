// SPDX-License-Identifier: Apache-2.0
#pragma once
// The exact visibility of any light in a scene of any size: only the triangles between the receiver and the light are
// looked at, and of these only the edges that bound their common shadow.

#include "reference/exact/triangle_tree.h"
#include "reference/exact_answer.h"

namespace umbrameter {

/// Corners, receiver and light are taken at their exact double values, and which region of the light is seen is decided in
/// exact arithmetic; areas are then added up in double precision, to about 1e-12. Surfaces within a millionth of the way
/// from the light's plane hide nothing (a lamp's own panel). Duplicate, touching, overlapping and edge-on triangles and those
/// that cross the planes of light or receiver are all part of the answer.
ExactLight exact_light(const TriangleTree& tree, const ExactReceiver& receiver, const Light& light);

}  // namespace umbrameter

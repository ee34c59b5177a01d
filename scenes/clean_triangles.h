// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finds triangles that no renderer can agree about: without area, or exactly on top of one another.

#include "scenes/scene.h"

#include <cstdint>
#include <vector>

namespace umbrameter {

enum class TriangleFault : uint8_t { none, zero_area, duplicate };

/// One entry per triangle of `scene`. Zero area: repeated positions, or a cross product of exactly 0 computed
/// in double from the float positions. Duplicate: the same three positions as an earlier triangle, in any
/// order.
std::vector<TriangleFault> find_triangle_faults(const Scene& scene);

/// Removes the faulty triangles and the vertices no triangle uses; parts shrink with them and vanish when
/// empty.
void remove_triangles(Scene& scene, const std::vector<TriangleFault>& faults);

}  // namespace umbrameter

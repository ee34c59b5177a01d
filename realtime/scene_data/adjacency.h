// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which triangles share an edge. No GL calls.

#include "scenes/scene.h"

#include <cstdint>
#include <vector>

namespace umbrameter {

inline constexpr uint32_t kNoNeighbour = 0xffffffffu;

/// Of triangle t (the scene's own first, then mesh by mesh those of instances, once) the triangles across its edges ab, bc and ca
/// at 3 t, 3 t + 1 and 3 t + 2: numbers in the same order, or kNoNeighbour. Edges are the same where their ends stand in the same
/// places, whatever their vertices are called. An edge of one triangle or of more than two has no neighbour.
std::vector<uint32_t> triangle_neighbours(const Scene& scene);

}  // namespace umbrameter

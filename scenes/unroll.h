// SPDX-License-Identifier: Apache-2.0
#pragma once
// Repeated meshes where they cannot stay so.

#include "scenes/mesh_data.h"

namespace umbrameter {

/// Every place that squashes() a repeated mesh gets a copy of it among `mesh`'s own triangles; the other places stay.
void unroll_squashed(MeshData& mesh);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// The `shape = "..."` keys of a [[mesh]].

#include "core/toml.h"
#include "scenes/mesh_data.h"

namespace umbrameter {

/// Builds the shape that `reader` names, reading its keys (docs/scene-format.md). Error{input} for an unknown
/// shape and for sizes and counts outside their limits.
MeshData read_shape(TomlReader& reader);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// [[light]] of a scene file.

#include "core/toml.h"
#include "scenes/light.h"

namespace umbrameter {

/// Reads one `table` (docs/scene-format.md). Without `tangent` the light's x axis is horizontal, or along
/// world x for a light that faces straight up or down. Error{input} for a light of zero size, without a
/// direction, or with a tangent along its direction.
Light read_light(const TomlNode& table);

}  // namespace umbrameter

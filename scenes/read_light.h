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

/// The x axis of a light that has no `tangent`; unit. `direction_world` must be unit.
glm::dvec3 default_tangent(const glm::dvec3& direction_world);

}  // namespace umbrameter

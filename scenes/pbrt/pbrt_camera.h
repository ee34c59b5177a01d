// SPDX-License-Identifier: Apache-2.0
#pragma once
// pbrt's perspective camera.

#include "scenes/foreign/foreign_scene.h"
#include "scenes/pbrt/pbrt_parameters.h"

#include <glm/mat4x4.hpp>

#include <optional>

namespace umbrameter {

/// Adds the camera to `scene`, and counts what is not carried over. `film` may be absent: then it is pbrt's own. Error{input} for
/// angles, windows and sizes that are none.
void add_pbrt_camera(const PbrtParameters& camera, const glm::dmat4& world_from_camera,
                     const std::optional<PbrtParameters>& film, ForeignScene& scene);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes far from the origin, moved to it: both renderers compute in floats, which would lose what positions still hold.

#include "core/image.h"
#include "scenes/scene.h"

#include <optional>

namespace umbrameter {

/// A scene less `origin_world`, every position of its own triangles exactly; instances stand where the difference is rounded
/// to floats.
struct LocalScene {
  Scene scene;
  glm::dvec3 origin_world{0.0};
};

/// Absent for scenes that are near the origin for their size, along every axis: nearly all.
std::optional<LocalScene> local_scene(const Scene& scene);

/// Adds the origin to position.x/y/z where something is hit.
void add_origin(const glm::dvec3& origin_world, Image& image);

}  // namespace umbrameter

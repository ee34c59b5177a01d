// SPDX-License-Identifier: Apache-2.0
#pragma once
// What tells scenes and pictures on the GPU apart.

#include "core/renderer.h"
#include "scenes/scene.h"

#include <string>

namespace umbrameter {

/// Of the geometry; a loaded scene brings its hash along.
std::string geometry_key(const Scene& scene);

/// Of what a G-buffer shows beyond the geometry. The active light may change without the scene's hash.
std::string picture_key(const Scene& scene, const RenderRequest& request);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// What Scene::hash stands for.

#include "core/hash.h"
#include "scenes/scene.h"

namespace umbrameter {

/// Of everything that can change a picture but the choice of the active light: the scene as it is now, whatever its
/// `hash` says.
std::string hash_scene(const Scene& scene);

/// Feeds what triangles with holes add to the geometry: nothing for a solid scene.
void hash_cutouts(Hasher& hasher, const Scene& scene);
/// Feeds what instances add: nothing for a scene without.
void hash_instances(Hasher& hasher, const Scene& scene);

}  // namespace umbrameter

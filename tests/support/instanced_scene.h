// SPDX-License-Identifier: Apache-2.0
#pragma once
// A small scene whose trees are one mesh in several places: turned, scaled, stretched and mirrored.

#include "scenes/scene.h"

namespace umbrameter {

struct InstancedSceneOptions {
  bool is_smooth = false;   // crowns have shading normals
  bool has_leaves = false;  // crowns hold a card with holes
};

/// A floor of its own triangles and six trees. Its camera sees all of them; hash and bounds are set.
Scene instanced_scene(const Light& light, const InstancedSceneOptions& options = {});

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene as files for another program (docs/your-engine.md): scene.obj and scene.json.

#include "scenes/scene.h"

#include <string>

namespace umbrameter {

/// World-space triangles, positions to the last bit; one group a part; normals where the scene has any. Instances become
/// triangles of their own: Error{input} as flattened().
std::string scene_obj_text(const Scene& scene);

/// Camera and active light, under the name that people know the scene by. `mesh_hash` is a hash of the geometry alone.
std::string scene_json_text(const Scene& scene, const std::string& name, int width_px, int height_px);

/// Of positions, normals, triangles and parts: equal for every camera and light.
std::string mesh_hash(const Scene& scene);

}  // namespace umbrameter

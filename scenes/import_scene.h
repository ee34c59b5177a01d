// SPDX-License-Identifier: Apache-2.0
#pragma once
// Another program's file as a scene file that refers to it.

#include "scenes/imported_scene.h"

namespace umbrameter {

/// True for names of files that hold scenes, not meshes alone: .gltf, .glb, .fbx.
bool is_importable(const std::string& name);

/// The file's cameras and lights, and its meshes by reference, at the moment `at` of its animation. `mesh_file` as write_scene().
/// Error{input} for files that cannot be read (scenes/gltf/import_gltf.h, scenes/assimp/import_assimp.h), and for `at` of one without
/// animations.
ImportedScene import_file(const std::filesystem::path& path, const std::optional<AnimationTime>& at = {},
                          const std::filesystem::path& mesh_file = {});

}  // namespace umbrameter

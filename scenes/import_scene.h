// SPDX-License-Identifier: Apache-2.0
#pragma once
// Another program's file as a scene file that refers to it.

#include "scenes/imported_scene.h"
#include "scenes/mesh_filter.h"

namespace umbrameter {

/// True for names of files that hold scenes, not meshes alone: .gltf, .glb, .fbx, .xml (Mitsuba), .pbrt.
bool is_importable(const std::string& name);

/// The file's cameras and lights, and its meshes by reference, at the moment `at` of its animation. `mesh_file` as write_scene().
/// Error{input} for files that cannot be read (scenes/gltf/import_gltf.h, scenes/assimp/import_assimp.h,
/// scenes/mitsuba/read_mitsuba.h, scenes/pbrt/read_pbrt.h), and for `at` of one without
/// animations.
ImportedScene import_file(const std::filesystem::path& path, const std::optional<AnimationTime>& at = {},
                          const std::filesystem::path& mesh_file = {});

/// True for scene files of other renderers: .xml, .pbrt.
bool is_foreign_scene(const std::string& name);

/// The meshes of such a file as one. Error{input} as its reader and foreign_mesh() (scenes/foreign/foreign_scene.h).
MeshData load_foreign_mesh(const std::filesystem::path& path, const MeshFilter& filter,
                           std::vector<std::string>& warnings);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#pragma once
// A glTF file as a scene file that refers to it.

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

struct ImportedScene {
  std::string toml;  // docs/scene-format.md; its mesh is the glTF file, by name
  std::vector<std::string> warnings;
};

/// Cameras: the first perspective one that a node holds; the others stand in the text as comments. Without one the scene
/// is seen from a corner of its bounds. Lights (KHR_lights_punctual): point -> sphere, spot -> disk, directional -> sun. glTF
/// lights have no size: "extras" of the node, else of the light, may give `radius` or `size` (of a rect: a spot with
/// it) or `angular_diameter_deg`; else 0.05 m and 0.53 degrees are taken, with a warning. Without lights a sun stands
/// high. The scene file calls the mesh's file `mesh_file`; empty: by its name, as if they stood side by side. Error{input}
/// as open_gltf() and load_gltf_mesh().
ImportedScene import_gltf(const std::filesystem::path& path, const std::filesystem::path& mesh_file = {});

}  // namespace umbrameter

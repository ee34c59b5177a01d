// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a glTF material says about holes.

#include "scenes/cutouts.h"
#include "scenes/gltf/gltf_model.h"

#include <glm/mat3x3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct GltfHoles {
  AlphaMask mask;
  int texture_set = 0;           // TEXCOORD_<n>
  glm::dmat3 uv_from_file{1.0};  // of homogeneous coordinates: KHR_texture_transform, and v upwards
};

/// Of material `material` (-1 = none). Absent where it is solid; what is odd is said in `warnings`.
std::optional<GltfHoles> read_gltf_holes(const GltfFile& file, int material,
                                         std::vector<std::string>& warnings);

}  // namespace umbrameter

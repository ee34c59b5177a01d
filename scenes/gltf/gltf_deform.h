// SPDX-License-Identifier: Apache-2.0
#pragma once
// What bends a glTF mesh: morph targets and skins.

#include "scenes/gltf/gltf_model.h"
#include "scenes/skin.h"

#include <span>

namespace umbrameter {

/// The accessor of an attribute; null where there is none.
const int* find_gltf_attribute(const tinygltf::Primitive& primitive, const std::string& name);

/// Adds the targets' displacements of positions and normals, times `weights`; a weight that is missing is 0. Error{input} for more
/// weights than targets, targets of another number of vertices, and values that are not finite.
void apply_gltf_morphs(const GltfFile& file, const tinygltf::Primitive& source,
                       std::span<const double> weights, Primitive& primitive);

/// Skin `skin` for a primitive of `vertex_count` vertices. Weights that sum to 1 but for 1 %, as those of bytes do, are scaled to
/// it. Error{input} for a skin or joints that are not there or not in the scene, fewer inverse bind matrices than joints, vertices
/// without joints, joint numbers out of range, and weights that are negative, not finite or of another sum.
Skinning read_gltf_skin(const GltfFile& file, const tinygltf::Primitive& source, int skin,
                        size_t vertex_count);

}  // namespace umbrameter

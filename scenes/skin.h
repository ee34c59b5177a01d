// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes that joints move: linear blend skinning, as glTF 2.0 (3.7.3.3) and FBX clusters define it.

#include "scenes/primitives.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace umbrameter {

/// How far weights may be from a sum of 1 by rounding: four bytes are off by up to 0.008.
inline constexpr double kWeightSumError = 0.01;

struct JointInfluence {
  uint32_t joint = 0;
  double weight = 0.0;
};

/// Which joints move a primitive's vertices, and where they take it.
struct Skinning {
  std::vector<glm::dmat4> world_from_mesh;  // by joint: where the joint is, times its inverse bind matrix
  std::vector<size_t> first_influence;      // by vertex; its end stands behind it
  std::vector<JointInfluence> influences;   // weights of a vertex sum to 1
};

/// Moves positions and normals by the weighted mean of their joints' matrices, and turns triangles most of whose vertices it
/// mirrors: outside stays outside.
void place_by_joints(Primitive& primitive, const Skinning& skinning);

}  // namespace umbrameter

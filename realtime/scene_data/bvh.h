// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tree of boxes around a scene's triangles, as lib/bvh.glsl walks it. Embree builds it (binned surface area heuristic, two
// children, one triangle a leaf); its own trees cannot be had. No GL calls.

#include "scenes/scene.h"

#include <glm/vec4.hpp>

#include <vector>

namespace umbrameter {

// A link names a node by its place in units of kBvhRows rows; a leaf, by these bits and a number below them.
inline constexpr uint32_t kBvhNone = 0xffffffffu;
inline constexpr uint32_t kBvhTriangle = 0x80000000u;  // in the order of scene.triangles' buffer
inline constexpr uint32_t kBvhInstance = 0xc0000000u;  // its record's place
inline constexpr size_t kBvhRows = 4;

/// Rows of four words, kBvhRows each of
///   the head      link of the root; the rest 0
///   a node        low corner of one child's box and its link, high corner and 0; the same of the other child
///   an instance   mesh_from_world by rows; link of its mesh's root, number of the instance, its first triangle's, 0
/// Numbers of triangles and instances are those of SceneBuffers. Floats are kept as their bits. A scene without triangles has the
/// root kBvhNone. Error{internal} when Embree fails.
std::vector<glm::uvec4> make_bvh(const Scene& scene);

}  // namespace umbrameter

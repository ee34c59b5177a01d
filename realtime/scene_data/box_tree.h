// SPDX-License-Identifier: Apache-2.0
#pragma once
// A binary tree over boxes, built by Embree.

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace umbrameter {

struct Box {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};
};

struct BoxNode {
  std::array<Box, 2> boxes;            // around the children
  std::array<uint32_t, 2> children{};  // nodes, or of leaves the numbers of their boxes
  std::array<bool, 2> is_leaf{};
};

/// Links go down at most so many nodes: what a walker's stack must hold.
inline constexpr unsigned kBoxTreeDepth = 56;

/// Over at least two boxes; node 0 is the root. Every box is a leaf of its own. Error{internal} when Embree fails, which it does
/// for more than 256 boxes of one middle.
std::vector<BoxNode> build_box_tree(std::span<const Box> boxes);

}  // namespace umbrameter

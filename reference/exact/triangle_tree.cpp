// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/triangle_tree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace umbrameter {

namespace {

constexpr uint32_t kLeafTriangles = 4;

struct Box {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};
  void add(const glm::vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
};

glm::vec3 corner(const Scene& scene, uint32_t triangle, int k) {
  return scene.positions_world[scene.triangles[triangle][k]];
}

/// Three times the middle.
glm::vec3 middle(const Scene& scene, uint32_t triangle) {
  return corner(scene, triangle, 0) + corner(scene, triangle, 1) + corner(scene, triangle, 2);
}

/// The highest that a point of the box rises over the side's plane.
template <class Node>
double highest(const Node& node, const KeptSide& side) {
  double value = 0.0;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<size_t>(k);
    value += std::max(side.normal_world[k] * (static_cast<double>(node.min[axis]) - side.origin_world[k]),
                      side.normal_world[k] * (static_cast<double>(node.max[axis]) - side.origin_world[k]));
  }
  return value;
}

double highest(const Scene& scene, uint32_t triangle, const KeptSide& side) {
  double value = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 offset = glm::dvec3(corner(scene, triangle, k)) - side.origin_world;
    value = std::max(value, glm::dot(side.normal_world, offset));
  }
  return value;
}

}  // namespace

TriangleTree::TriangleTree(const Scene& scene) : scene_(scene), order_(scene.triangles.size()) {
  for (const glm::vec3& p : scene.positions_world) {
    extent_world_ = std::max<double>({extent_world_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  weld();
  std::iota(order_.begin(), order_.end(), 0u);
  if (!order_.empty()) build(0, static_cast<uint32_t>(order_.size()));
}

void TriangleTree::weld() {
  const auto& positions = scene_.positions_world;
  const auto key = [&](uint32_t i) {
    return std::tuple(positions[i].x, positions[i].y, positions[i].z);  // -0 equals 0
  };
  std::vector<uint32_t> sorted(positions.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::ranges::sort(sorted, {}, key);
  place_of_vertex_.resize(positions.size());
  for (size_t i = 0; i < sorted.size(); ++i) {
    const bool is_same = i > 0 && key(sorted[i]) == key(sorted[i - 1]);
    place_of_vertex_[sorted[i]] = is_same ? place_of_vertex_[sorted[i - 1]] : sorted[i];
  }
}

glm::uvec3 TriangleTree::places(uint32_t triangle) const {
  const glm::uvec3 index = scene_.triangles[triangle];
  return {place_of_vertex_[index.x], place_of_vertex_[index.y], place_of_vertex_[index.z]};
}

void TriangleTree::build(uint32_t first, uint32_t count) {
  Box box, middles;
  for (uint32_t i = first; i < first + count; ++i) {
    for (int k = 0; k < 3; ++k) box.add(corner(scene_, order_[i], k));
    middles.add(middle(scene_, order_[i]));
  }
  const size_t node = nodes_.size();
  nodes_.push_back({{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}, first, count});
  if (count <= kLeafTriangles) return;
  const glm::vec3 size = middles.max - middles.min;
  int axis = size.x > size.y ? 0 : 1;
  if (size.z > size[axis]) axis = 2;
  const uint32_t half = count / 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + half, begin + count,
                   [&](uint32_t a, uint32_t b) { return middle(scene_, a)[axis] < middle(scene_, b)[axis]; });
  build(first, half);
  nodes_[node].first = static_cast<uint32_t>(nodes_.size());
  nodes_[node].count = 0;
  build(first + half, count - half);
}

std::vector<uint32_t> TriangleTree::near(std::span<const KeptSide> sides) const {
  constexpr double kRounding = 1e-14;
  std::vector<double> least;
  for (const KeptSide& side : sides) {
    least.push_back(-kRounding * extent_world_ * glm::length(side.normal_world));
  }
  const auto is_near = [&](const auto&... what) {
    for (size_t i = 0; i < sides.size(); ++i) {
      if (highest(what..., sides[i]) < least[i]) return false;
    }
    return true;
  };
  std::vector<uint32_t> found;
  std::vector<uint32_t> stack;
  if (!nodes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const uint32_t index = stack.back();
    stack.pop_back();
    const Node& node = nodes_[index];
    if (!is_near(node)) continue;
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (is_near(scene_, order_[i])) found.push_back(order_[i]);
    }
    if (node.count > 0) continue;
    stack.push_back(index + 1);
    stack.push_back(node.first);
  }
  return found;
}

}  // namespace umbrameter

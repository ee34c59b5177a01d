// SPDX-License-Identifier: Apache-2.0
#include "realtime/scene_data/bvh.h"

#include "realtime/scene_data/box_tree.h"
#include "scenes/instances.h"

#include <bit>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

glm::uvec4 bits_of(const glm::vec3& v, uint32_t word) {
  return {std::bit_cast<uint32_t>(v.x), std::bit_cast<uint32_t>(v.y), std::bit_cast<uint32_t>(v.z), word};
}

/// The nearest floats that are no higher, or no lower.
glm::vec3 rounded_towards(const glm::dvec3& p, float limit) {
  glm::vec3 rounded(p);
  for (int k = 0; k < 3; ++k) {
    const bool is_inside = limit < 0.0f ? double{rounded[k]} > p[k] : double{rounded[k]} < p[k];
    if (is_inside) rounded[k] = std::nextafter(rounded[k], limit);
  }
  return rounded;
}

Box box_of(const Bounds3& bounds) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {rounded_towards(bounds.min, -kInfinity), rounded_towards(bounds.max, kInfinity)};
}

std::vector<Box> triangle_boxes(const SharedList<glm::vec3>& positions,
                                const SharedList<glm::uvec3>& triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const glm::uvec3& t : triangles) {
    const glm::vec3 &a = positions[t.x], &b = positions[t.y], &c = positions[t.z];
    boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  }
  return boxes;
}

class BvhRows {
 public:
  BvhRows() : rows_(kBvhRows, glm::uvec4(0)) {}

  /// Leaf i of the tree becomes `leaves` + i.
  uint32_t add_tree(std::span<const Box> boxes, uint32_t leaves) {
    if (boxes.empty()) return kBvhNone;
    if (boxes.size() == 1) return leaves;
    return add(build_box_tree(boxes), 0, leaves);
  }

  uint32_t add_instance(const Instance& instance, uint32_t mesh_root, uint32_t number,
                        uint32_t first_triangle) {
    const auto place = static_cast<uint32_t>(rows_.size() / kBvhRows);
    const glm::dmat4 world_from_mesh(glm::dmat4x3(*instance.world_from_mesh));
    const glm::dmat4 mesh_from_world = glm::inverse(world_from_mesh);
    for (int row = 0; row < 3; ++row) {
      const glm::vec4 v(glm::transpose(mesh_from_world)[row]);
      rows_.push_back(bits_of(glm::vec3(v), std::bit_cast<uint32_t>(v.w)));
    }
    rows_.emplace_back(mesh_root, number, first_triangle, 0);
    return place;
  }

  /// Over two trees, of which there may be less.
  uint32_t join(const Box& one_box, uint32_t one, const Box& other_box, uint32_t other) {
    if (one == kBvhNone) return other;
    if (other == kBvhNone) return one;
    return add_node(one_box, one, other_box, other);
  }

  std::vector<glm::uvec4> finish(uint32_t root) && {
    rows_[0].x = root;
    return std::move(rows_);
  }

 private:
  uint32_t add_node(const Box& one_box, uint32_t one, const Box& other_box, uint32_t other) {
    const auto place = static_cast<uint32_t>(rows_.size() / kBvhRows);
    rows_.push_back(bits_of(one_box.low, one));
    rows_.push_back(bits_of(one_box.high, 0));
    rows_.push_back(bits_of(other_box.low, other));
    rows_.push_back(bits_of(other_box.high, 0));
    return place;
  }

  uint32_t add(const std::vector<BoxNode>& tree, uint32_t index, uint32_t leaves) {
    const BoxNode& node = tree[index];
    const uint32_t place = add_node(node.boxes[0], 0, node.boxes[1], 0);
    for (size_t k = 0; k < 2; ++k) {
      const uint32_t link = node.is_leaf[k] ? leaves + node.children[k] : add(tree, node.children[k], leaves);
      rows_[kBvhRows * place + 2 * k].w = link;
    }
    return place;
  }

  std::vector<glm::uvec4> rows_;
};

Box box_around(std::span<const Box> boxes) {
  Box whole;
  for (const Box& box : boxes) whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
  return whole;
}

/// Records lie one after the other, in the order of the boxes.
struct PlacedInstances {
  std::vector<Box> boxes;
  uint32_t first_record = 0;
};

PlacedInstances add_instances(const Scene& scene, BvhRows& rows) {
  PlacedInstances placed;
  std::vector<uint32_t> roots, firsts;  // of meshes
  auto first = static_cast<uint32_t>(scene.triangles.size());
  for (const auto& mesh : scene.instanced) {
    roots.push_back(rows.add_tree(triangle_boxes(mesh->positions, mesh->triangles), kBvhTriangle | first));
    firsts.push_back(first);
    first += static_cast<uint32_t>(mesh->triangles.size());
  }
  size_t mesh = 0;
  uint32_t number = 0;
  for (const Instance& instance : list_instances(scene)) {
    while (scene.instanced[mesh].get() != instance.mesh) ++mesh;
    const uint32_t place = rows.add_instance(instance, roots[mesh], number, firsts[mesh]);
    if (number++ == 0) placed.first_record = place;
    placed.boxes.push_back(box_of(instance.bounds_world()));
  }
  return placed;
}

}  // namespace

std::vector<glm::uvec4> make_bvh(const Scene& scene) {
  BvhRows rows;
  const std::vector<Box> own_boxes = triangle_boxes(scene.positions_world, scene.triangles);
  const uint32_t own = rows.add_tree(own_boxes, kBvhTriangle);
  const PlacedInstances placed = add_instances(scene, rows);
  const uint32_t instances = rows.add_tree(placed.boxes, kBvhInstance | placed.first_record);
  return std::move(rows).finish(rows.join(box_around(own_boxes), own, box_around(placed.boxes), instances));
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "reference/occluder_tree.h"

#include "core/error.h"
#include "scenes/instances.h"

#include <glm/common.hpp>

#include <algorithm>
#include <new>
#include <vector>

namespace umbrameter {

namespace {

OccluderInner& inner_of(void* node) {
  return *static_cast<OccluderInner*>(static_cast<OccluderNode*>(node));
}

RTCBuildPrimitive primitive_of(const Scene& scene, uint32_t triangle) {
  const glm::uvec3 index = scene.triangles[triangle];
  const glm::vec3& a = scene.positions_world[index.x];
  const glm::vec3& b = scene.positions_world[index.y];
  const glm::vec3& c = scene.positions_world[index.z];
  const glm::vec3 low = glm::min(a, glm::min(b, c));
  const glm::vec3 high = glm::max(a, glm::max(b, c));
  return {low.x, low.y, low.z, 0, high.x, high.y, high.z, triangle};
}

OccluderBox box_of(const Instance& instance) {
  const Bounds3 bounds = instance.bounds_world();
  OccluderBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<size_t>(axis);
    box.min[k] = static_cast<float>(bounds.min[axis]);
    box.max[k] = static_cast<float>(bounds.max[axis]);
  }
  return box;
}

RTCBuildPrimitive primitive_of(const OccluderBox& box, uint32_t entry) {
  return {box.min[0], box.min[1], box.min[2], 0, box.max[0], box.max[1], box.max[2], entry};
}

void* create_inner(RTCThreadLocalAllocator allocator, unsigned int, void*) {
  auto* inner = new (rtcThreadLocalAlloc(allocator, sizeof(OccluderInner), 16)) OccluderInner{};
  return static_cast<OccluderNode*>(inner);
}

void set_children(void* node, void** children, unsigned int count, void*) {
  OccluderInner& inner = inner_of(node);
  inner.child_count = count;
  for (unsigned int i = 0; i < count; ++i) inner.children[i] = static_cast<const OccluderNode*>(children[i]);
}

void set_boxes(void* node, const RTCBounds** bounds, unsigned int count, void*) {
  OccluderInner& inner = inner_of(node);
  for (unsigned int i = 0; i < count; ++i) {
    const RTCBounds& b = *bounds[i];
    inner.boxes[i] = {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
  }
}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, size_t count,
                  void*) {
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(OccluderLeaf), 16)) OccluderLeaf{};
  leaf->triangle_count = static_cast<uint32_t>(count);
  for (size_t i = 0; i < count; ++i) leaf->triangles[i] = primitives[i].primID;
  return static_cast<OccluderNode*>(leaf);
}

}  // namespace

void OccluderTree::clear() {
  root_ = nullptr;
  bvh_.reset();
  instance_boxes_.clear();
}

void OccluderTree::build(const EmbreeScene& embree, const Scene& scene) {
  clear();
  triangle_count_ = static_cast<uint32_t>(scene.triangles.size());
  for (const Instance& instance : list_instances(scene)) instance_boxes_.push_back(box_of(instance));
  std::vector<RTCBuildPrimitive> primitives(triangle_count_ + instance_boxes_.size());
  if (primitives.empty()) return;
  for (uint32_t i = 0; i < triangle_count_; ++i) primitives[i] = primitive_of(scene, i);
  for (uint32_t i = triangle_count_; i < primitives.size(); ++i)
    primitives[i] = primitive_of(instance_boxes_[i - triangle_count_], i);
  bvh_.reset(rtcNewBVH(embree.device()));
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.bvh = bvh_.get();
  arguments.maxBranchingFactor = OccluderInner::kChildren;
  arguments.maxLeafSize = OccluderLeaf::kTriangles;
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_inner;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_boxes;
  arguments.createLeaf = create_leaf;
  root_ = static_cast<const OccluderNode*>(rtcBuildBVH(&arguments));
  if (root_ == nullptr) fail_environment("out of memory while building the tree of occluders");
}

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/scene_data/box_tree.h"

#include "core/error.h"

#include <embree3/rtcore.h>

#include <memory>
#include <new>

namespace umbrameter {
namespace {

/// A node as Embree's callbacks make it, in memory of its tree.
struct BuiltNode {
  std::array<Box, 2> boxes;
  std::array<BuiltNode*, 2> children{};  // null in leaves
  uint32_t box = 0;                      // of a leaf
};

void* create_built_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), 16)) BuiltNode;
}

void* create_built_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, size_t,
                        void*) {
  auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), 16)) BuiltNode;
  leaf->box = primitives->primID;
  return leaf;
}

void set_built_children(void* node, void** children, unsigned count, void*) {
  for (unsigned k = 0; k < count; ++k)
    static_cast<BuiltNode*>(node)->children[k] = static_cast<BuiltNode*>(children[k]);
}

void set_built_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned k = 0; k < count; ++k) {
    const RTCBounds& b = *bounds[k];
    static_cast<BuiltNode*>(node)->boxes[k] = {{b.lower_x, b.lower_y, b.lower_z},
                                               {b.upper_x, b.upper_y, b.upper_z}};
  }
}

std::vector<RTCBuildPrimitive> build_primitives(std::span<const Box> boxes) {
  std::vector<RTCBuildPrimitive> primitives;
  primitives.reserve(boxes.size());
  for (const Box& box : boxes) {
    const auto id = static_cast<uint32_t>(primitives.size());
    primitives.push_back({box.low.x, box.low.y, box.low.z, 0, box.high.x, box.high.y, box.high.z, id});
  }
  return primitives;
}

/// In the order of a walk that goes down first.
uint32_t add_built(const BuiltNode& built, std::vector<BoxNode>& nodes) {
  const auto index = static_cast<uint32_t>(nodes.size());
  nodes.push_back({built.boxes, {}, {}});
  for (size_t k = 0; k < 2; ++k) {
    const BuiltNode& child = *built.children[k];
    const bool is_leaf = child.children[0] == nullptr;
    const uint32_t link = is_leaf ? child.box : add_built(child, nodes);
    nodes[index].children[k] = link;
    nodes[index].is_leaf[k] = is_leaf;
  }
  return index;
}

using EmbreeDevice = std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)>;
using EmbreeTree = std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)>;

}  // namespace

std::vector<BoxNode> build_box_tree(std::span<const Box> boxes) {
  const EmbreeDevice device(rtcNewDevice(nullptr), rtcReleaseDevice);
  UMBRAMETER_ASSERT(device != nullptr, "{}", "Embree gives no device");
  const EmbreeTree tree(rtcNewBVH(device.get()), rtcReleaseBVH);
  std::vector<RTCBuildPrimitive> primitives = build_primitives(boxes);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = kBoxTreeDepth;
  arguments.maxLeafSize = 1;
  arguments.bvh = tree.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_built_node;
  arguments.createLeaf = create_built_leaf;
  arguments.setNodeChildren = set_built_children;
  arguments.setNodeBounds = set_built_bounds;
  const void* root = rtcBuildBVH(&arguments);
  UMBRAMETER_ASSERT(root != nullptr, "Embree builds no tree over {} boxes", boxes.size());
  std::vector<BoxNode> nodes;
  nodes.reserve(boxes.size());
  add_built(*static_cast<const BuiltNode*>(root), nodes);
  return nodes;
}

}  // namespace umbrameter

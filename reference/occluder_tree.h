// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tree of boxes over a scene's triangles that, unlike Embree's own, can be walked with volumes instead of rays. An instance
// is one box: what meets it may meet its triangles.

#include "reference/embree_scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace umbrameter {

struct OccluderBox {
  std::array<float, 3> min;
  std::array<float, 3> max;
};

/// The head of an inner node or a leaf.
struct OccluderNode {
  uint32_t triangle_count;  // 0: an inner node
};
struct OccluderInner : OccluderNode {
  static constexpr uint32_t kChildren = 4;
  uint32_t child_count;
  std::array<OccluderBox, kChildren> boxes;
  std::array<const OccluderNode*, kChildren> children;
};
struct OccluderLeaf : OccluderNode {
  static constexpr uint32_t kTriangles = 8;
  std::array<uint32_t, kTriangles>
      triangles;  // beyond the scene's own: instances, in the order of list_instances()
};

/// Built by Embree's builder in Embree's memory, which embree.memory_bytes() counts.
class OccluderTree {
 public:
  /// Replaces what was there. Error{environment} when memory runs out.
  void build(const EmbreeScene& embree, const Scene& scene);
  void clear();
  /// Null for a scene without triangles.
  const OccluderNode* root() const { return root_; }
  /// Of entry `entry` of a leaf, if it is an instance.
  const OccluderBox* instance_box(uint32_t entry) const {
    return entry < triangle_count_ ? nullptr : &instance_boxes_[entry - triangle_count_];
  }

 private:
  std::unique_ptr<std::remove_pointer_t<RTCBVH>, EmbreeRelease<rtcReleaseBVH>> bvh_;
  const OccluderNode* root_ = nullptr;
  uint32_t triangle_count_ = 0;  // of the scene's own
  std::vector<OccluderBox> instance_boxes_;
};

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "realtime/views/instance_boxes.h"

#include "realtime/views/clip_planes.h"

namespace umbrameter {

std::vector<InstanceBox> make_instance_boxes(const Scene& scene) {
  std::vector<InstanceBox> boxes;
  for (const Instance& instance : list_instances(scene)) {
    const Bounds3 bounds = instance.bounds_world();
    boxes.push_back({glm::vec3(bounds.min), glm::vec3(bounds.max)});
  }
  return boxes;
}

std::vector<uint32_t> instances_in_view(std::span<const InstanceBox> boxes, const glm::dmat4& clip_from_world,
                                        bool clamps_depth) {
  const ClipPlanes planes = clip_planes(clip_from_world, clamps_depth);
  std::vector<uint32_t> numbers;
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    if (!is_clipped(planes, boxes[i].min_world, boxes[i].max_world)) numbers.push_back(i);
  }
  return numbers;
}

}  // namespace umbrameter

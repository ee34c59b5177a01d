// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which instances can reach a picture or a map at all. No GL.

#include "scenes/instances.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace umbrameter {

struct InstanceBox {
  glm::vec3 min_world;
  glm::vec3 max_world;
};

/// In the order of list_instances().
std::vector<InstanceBox> make_instance_boxes(const Scene& scene);

/// Numbers of those of which GL may draw a part, ascending. `clamps_depth`: nothing is clipped by distance.
std::vector<uint32_t> instances_in_view(std::span<const InstanceBox> boxes, const glm::dmat4& clip_from_world,
                                        bool clamps_depth);

}  // namespace umbrameter

// SPDX-License-Identifier: Apache-2.0
#include "scenes/skin.h"

#include <glm/matrix.hpp>

namespace umbrameter {

void place_by_joints(Primitive& primitive, const Skinning& skinning) {
  std::vector<bool> is_mirrored(primitive.vertices.size());
  for (size_t v = 0; v < primitive.vertices.size(); ++v) {
    glm::dmat4 world_from_mesh(0.0);
    for (size_t i = skinning.first_influence[v]; i < skinning.first_influence[v + 1]; ++i)
      world_from_mesh +=
          skinning.influences[i].weight * skinning.world_from_mesh[skinning.influences[i].joint];
    place(primitive.vertices[v], world_from_mesh);
    is_mirrored[v] = glm::determinant(glm::dmat3(world_from_mesh)) < 0.0;
  }
  for (glm::uvec3& t : primitive.triangles) {
    if (int{is_mirrored[t.x]} + int{is_mirrored[t.y]} + int{is_mirrored[t.z]} >= 2) std::swap(t.y, t.z);
  }
}

}  // namespace umbrameter

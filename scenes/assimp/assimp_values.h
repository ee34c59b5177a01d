// SPDX-License-Identifier: Apache-2.0
#pragma once
// assimp's vectors and matrices as ours.

#include <assimp/matrix4x4.h>
#include <assimp/quaternion.h>
#include <assimp/vector3.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace umbrameter {

inline glm::dvec3 vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

inline glm::dquat quaternion_of(const aiQuaternion& q) {
  return {q.w, q.x, q.y, q.z};
}

inline glm::dmat4 matrix_of(const aiMatrix4x4& m) {
  return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4,
                                   m.d1, m.d2, m.d3, m.d4));
}

inline bool is_finite(const aiVector3D& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace umbrameter

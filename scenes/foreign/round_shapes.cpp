// SPDX-License-Identifier: Apache-2.0
#include "scenes/foreign/round_shapes.h"

#include "scenes/foreign/foreign_scene.h"
#include "scenes/shapes.h"

namespace umbrameter {

Primitive unit_rectangle() {
  Primitive made;
  for (const glm::vec2 uv : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
    made.vertices.push_back({.p = {2.0 * uv.x - 1.0, 2.0 * uv.y - 1.0, 0.0}, .uv = uv});
  made.triangles = {{0, 1, 2}, {0, 2, 3}};
  return made;
}

Primitive unit_disk() {
  MeshData disk = make_disk(1.0, kRoundDisk);  // faces +y
  for (glm::dvec3& p : disk.positions) p = {p.x, -p.z, p.y};
  return primitive_of(disk, {});
}

Primitive unit_sphere() {
  return primitive_of(make_sphere(1.0, kRoundSphere, true), {});
}

Primitive unit_cube() {
  MeshData cube = make_box({2, 2, 2});  // stands on y = 0
  for (glm::dvec3& p : cube.positions) p.y -= 1.0;
  return primitive_of(cube, {});
}

}  // namespace umbrameter

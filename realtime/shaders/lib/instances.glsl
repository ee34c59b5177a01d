// SPDX-License-Identifier: Apache-2.0
// Where instances stand. Twin: scenes/instances.h; layout: realtime/harness/instance_buffers.cpp.

struct InstanceRecord {
  vec4 row_x;     // world_from_mesh, by rows
  vec4 row_y;
  vec4 row_z;
  uint first_shown;     // of its triangles, in the scene's count
  uint first_triangle;  // of its mesh, in storage
  uint first_cutout;    // its mesh's triangles from here on have holes, counted from the mesh's first
  uint first_record;    // word of their first record (cutout.glsl)
};

layout(std430, binding = 4) readonly buffer Instances { InstanceRecord instances[]; };  // const: instance_buffers.h

// The same operations for the same vertex in every pass.
vec3 place_world(InstanceRecord instance, vec3 p_mesh) {
  precise vec3 p_world = vec3(dot(instance.row_x.xyz, p_mesh) + instance.row_x.w,
                              dot(instance.row_y.xyz, p_mesh) + instance.row_y.w,
                              dot(instance.row_z.xyz, p_mesh) + instance.row_z.w);
  return p_world;
}

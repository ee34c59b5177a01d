// SPDX-License-Identifier: Apache-2.0
// The triangle that a vertex belongs to, for vertex shaders of passes with `vertices`: every triangle of the scene is drawn with
// VERTICES_PER_TRIANGLE of them, which have no attributes. Layout: realtime/harness/scene_buffers.h.
#ifdef HAS_INSTANCES
#include "instances.glsl"
layout(location = 3) in uint instance_of_vertex;  // const: instance_buffers.h
#endif
#ifdef HAS_CUTOUTS
#include "cutout.glsl"
#endif

layout(std430, binding = 0) readonly buffer Positions { float positions_stored[]; };
layout(std430, binding = 1) readonly buffer Triangles { uint corners_stored[]; };

struct PulledTriangle {
  vec3 a_world;
  vec3 b_world;
  vec3 c_world;
  uint holes;  // record for is_hole_of_record() of cutout.glsl; 0: solid
};

/// Which of the triangle's vertices this is.
int pulled_vertex() { return gl_VertexID % VERTICES_PER_TRIANGLE; }

const uint kCorners = 3u;  // const: of a triangle; also coordinates of a position

vec3 stored_position(uint vertex) {
  uint at = kCorners * vertex;
  return vec3(positions_stored[at], positions_stored[at + 1u], positions_stored[at + 2u]);
}

#ifdef HAS_INSTANCES

PulledTriangle pulled_triangle() {
  InstanceRecord instance = instances[instance_of_vertex];
  uint of_mesh = uint(gl_VertexID / VERTICES_PER_TRIANGLE);
  uint at = kCorners * (instance.first_triangle + of_mesh);
  uint holes = 0u;
#ifdef HAS_CUTOUTS
  if (of_mesh >= instance.first_cutout)
    holes = instance.first_record + kRecordWords * (of_mesh - instance.first_cutout);
#endif
  return PulledTriangle(place_world(instance, stored_position(corners_stored[at])),
                        place_world(instance, stored_position(corners_stored[at + 1u])),
                        place_world(instance, stored_position(corners_stored[at + 2u])), holes);
}

#else

PulledTriangle pulled_triangle() {
  uint triangle = uint(gl_VertexID / VERTICES_PER_TRIANGLE);
  uint at = kCorners * triangle;
  uint holes = 0u;
#ifdef HAS_CUTOUTS
  if (triangle >= cutout_words[0]) holes = 1u + kRecordWords * (triangle - cutout_words[0]);
#endif
  return PulledTriangle(stored_position(corners_stored[at]), stored_position(corners_stored[at + 1u]),
                        stored_position(corners_stored[at + 2u]), holes);
}

#endif

// SPDX-License-Identifier: Apache-2.0
// The camera as rays through pixel centres, and the triangles as they stand in memory.
// Scaled view space: x and y divided by the tangents of the half field of view, z the distance along the view
// axis, so that x/z and y/z are normalised device coordinates.

layout(std140, binding = 1) uniform GBufferBlock {
  vec4 right_world;    // xyz unit, w = tan of half the horizontal field of view
  vec4 up_world;       // xyz unit, w = tan of half the vertical field of view
  vec4 forward_world;  // xyz unit, w = near_world
  vec4 eye_world_low;  // what frame.eye_world loses by rounding
  vec4 screen_px;      // width, height, by how much triangles grow for rasterisation, 0
  ivec4 has_normals;   // x
};

layout(std430, binding = 0) readonly buffer Positions { float positions_world[]; };
layout(std430, binding = 1) readonly buffer Triangles { uint triangle_corners[]; };
layout(std430, binding = 2) readonly buffer Normals { float normals_world[]; };

vec3 position_world(uint vertex) {
  return vec3(positions_world[3u * vertex], positions_world[3u * vertex + 1u], positions_world[3u * vertex + 2u]);
}

vec3 normal_world(uint vertex) {
  return vec3(normals_world[3u * vertex], normals_world[3u * vertex + 1u], normals_world[3u * vertex + 2u]);
}

uvec3 corners_of(uint triangle) {
  return uvec3(triangle_corners[3u * triangle], triangle_corners[3u * triangle + 1u],
               triangle_corners[3u * triangle + 2u]);
}

// Normalised device coordinates of a fragment's centre, y up.
vec2 ndc_of_fragment(vec2 fragment_px) { return 2.0 * fragment_px / screen_px.xy - 1.0; }

// SPDX-License-Identifier: Apache-2.0
// Vertices where a paraboloid shows them, and straight edges between: what engines draw, right only where triangles are small.
#include "paraboloid.glsl"
#include "spaces.glsl"

layout(location = 0) in vec3 p_world;

void main() {
  vec3 p_light = (VIEW.light_from_world * vec4(p_world, 1.0)).xyz;
  float distance_world = length(p_light);
  gl_ClipDistance[0] = p_light.z;  // const: the one clip plane
  gl_Position = vec4(paraboloid_place(p_light / distance_world), depth_of_distance(VIEW, distance_world), 1.0);
}

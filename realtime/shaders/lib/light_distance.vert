// SPDX-License-Identifier: Apache-2.0
// As light_map.vert, with the distance itself: stored depth ends at the far plane, filters look past it.
layout(location = 0) in vec3 p_world;
out float distance_world;

void main() {
  vec4 p_light = VIEW.light_from_world * vec4(p_world, 1.0);
  distance_world = p_light.z;
  gl_Position = VIEW.clip_from_light * p_light;
}

// SPDX-License-Identifier: Apache-2.0
// The box around each slice's receivers in light space: in each group first, then over all of them. Where slices overlap a
// receiver belongs to two.
#include "reductions.glsl"
#include "sdsm.glsl"

layout(local_size_x = 16, local_size_y = 16) in;  // const: 256 threads, which every device runs

const int kAxes = 3;  // const: of space
shared uvec2 bounds_of_group[kAxes * CASCADE_COUNT];

void widen(int cascade, vec3 p_light) {
  for (int axis = 0; axis < kAxes; ++axis) {
    uint bits = ordered_bits(p_light[axis]);
    atomicMin(bounds_of_group[kAxes * cascade + axis].x, bits);
    atomicMax(bounds_of_group[kAxes * cascade + axis].y, bits);
  }
}

void add_receiver(vec2 range_world, vec3 p_world) {
  vec3 p_light = (sun_from_world() * vec4(p_world, 1.0)).xyz;
  float distance_world = distance_along_axis(p_world);
  for (int cascade = 0; cascade < CASCADE_COUNT; ++cascade) {
    vec2 slice = slice_world(range_world, cascade);
    bool is_in_slice = distance_world >= slice.x && distance_world <= slice.y;
    if (is_in_slice || CASCADE_BOUNDS == CASCADE_BOUNDS_PICTURE) widen(cascade, p_light);
  }
}

void main() {
  uint index = gl_LocalInvocationIndex;
  if (index < kAxes * CASCADE_COUNT) bounds_of_group[index] = uvec2(~0u, 0u);
  barrier();
  vec2 range_world = vec2(number_of_ordered(receiver_range[0].x), number_of_ordered(receiver_range[0].y));
  for (int k = 0; k < kPixelsPerThread * kPixelsPerThread; ++k) {
    vec3 p_world;
    if (needs_map(pixel_of_thread(k), p_world)) add_receiver(range_world, p_world);
  }
  barrier();
  if (index >= kAxes * CASCADE_COUNT) return;
  atomicMin(receiver_bounds[index].x, bounds_of_group[index].x);
  atomicMax(receiver_bounds[index].y, bounds_of_group[index].y);
}

// SPDX-License-Identifier: Apache-2.0
// The nearest and the farthest receiver: in each group first, then over all of them.
#include "reductions.glsl"

layout(local_size_x = 16, local_size_y = 16) in;  // const: 256 threads, which every device runs

shared uint nearest_of_group;
shared uint farthest_of_group;

void main() {
  if (gl_LocalInvocationIndex == 0u) {
    nearest_of_group = ~0u;
    farthest_of_group = 0u;
  }
  barrier();
  for (int k = 0; k < kPixelsPerThread * kPixelsPerThread; ++k) {
    vec3 p_world;
    if (!needs_map(pixel_of_thread(k), p_world)) continue;
    uint bits = ordered_bits(distance_along_axis(p_world));
    atomicMin(nearest_of_group, bits);
    atomicMax(farthest_of_group, bits);
  }
  barrier();
  if (gl_LocalInvocationIndex != 0u) return;
  atomicMin(receiver_range[0].x, nearest_of_group);
  atomicMax(receiver_range[0].y, farthest_of_group);
}

// SPDX-License-Identifier: Apache-2.0
// What both reductions share: which pixels count.
#include "ordered_bits.glsl"

const int kPixelsPerThread = 2;  // along each side; groups of 16 x 16 threads cover 32 x 32 pixels

/// The pixel `k` of a thread's square.
ivec2 pixel_of_thread(int k) {
  return kPixelsPerThread * ivec2(gl_GlobalInvocationID.xy) + ivec2(k % kPixelsPerThread, k / kPixelsPerThread);
}

/// Whether the pixel's answer needs a map: background and surfaces turned away from the sun do not.
bool needs_map(ivec2 px, out vec3 p_world) {
  if (any(greaterThanEqual(px, frame.screen_and_seed.xy))) return false;
  vec4 position = texelFetch(gbuffer_position, px, 0);
  p_world = position.xyz;
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  return position.w != 0.0 && dot(n_world, frame.light_direction_world.xyz) < 0.0;
}

/// Distance along the camera's axis.
float distance_along_axis(vec3 p_world) { return (frame.clip_from_world * vec4(p_world, 1.0)).w; }

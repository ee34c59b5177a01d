// SPDX-License-Identifier: Apache-2.0
// pcss at the computed pixels, packed.
#include "blocker_search.glsl"
#include "checkerboard.glsl"
#include "light_filter.glsl"
#include "light_kernel.glsl"
#include "pixel.glsl"
#include "search_bound.glsl"

float visibility_of(Receiver receiver, vec2 noise) {
  AreaLight light = kernel_light();
  float z_blocker = mean_blocker_distance(light, receiver, noise, nearest_blocker_bound(light, receiver));
  return visible_share(light, receiver, z_blocker, z_blocker < receiver.p_light.z, noise);
}

void main() {
  int height = frame.screen_and_seed.y;
  ivec2 px = min(pixel_of(ivec2(gl_FragCoord.xy)), frame.screen_and_seed.xy - 1);  // the last one of odd sizes
  vec2 p_px = (vec2(px) + 0.5) * vec2(1.0, noise_stretch);
  Receiver receiver;
  bool has_receiver = fetch_receiver_at(flipped(px, height), receiver);
  vec2 noise = kernel_noise(seeded_position(p_px, frame.screen_and_seed.z));
  out_packed_visibility = has_receiver ? visibility_of(receiver, noise) : 1.0;
}

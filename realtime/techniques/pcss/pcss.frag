// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows (Fernando 2005) with kernels shaped like the light: search for blockers, place a
// plane at their mean distance, and ask the map along the rays from the receiver through that plane to the light.
#include "blocker_search.glsl"
#include "light_filter.glsl"
#include "pixel.glsl"
#include "search_bound.glsl"

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  vec2 noise = kernel_noise(noise_position());
  float z_search = nearest_blocker_bound(light, receiver);
  float z_blocker = mean_blocker_distance(light, receiver, noise, z_search);
  return visible_share(light, receiver, z_blocker, z_blocker < receiver.p_light.z, noise);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

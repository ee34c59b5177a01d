// SPDX-License-Identifier: Apache-2.0
// This frame's share of percentage-closer soft shadows: search and filter with the taps after those of the frame before.
#define TAPS_OVER_FRAMES
// const: of the group light_filter, which has other kernels too
#define KERNEL_LIGHT 0
#define KERNEL_JITTERED 2
#define KERNEL KERNEL_LIGHT
#define NOISE 1
#define EARLY_OUT 0
#include "blocker_search.glsl"
#include "light_filter.glsl"
#include "pixel.glsl"
#include "r2_sequence.glsl"
#include "search_bound.glsl"

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  vec2 noise = r2_offset(noise_position());
  float z_search = nearest_blocker_bound(light, receiver);
  float z_blocker = mean_blocker_distance(light, receiver, noise, z_search);
  return visible_share(light, receiver, z_blocker, z_blocker < receiver.p_light.z, noise);
}

void main() {
  Receiver receiver;
  out_current = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

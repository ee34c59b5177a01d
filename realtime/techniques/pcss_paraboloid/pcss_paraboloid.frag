// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows (Fernando 2005) over two paraboloids: the same search and filter as over a single map, in
// a view that faces each receiver.
#include "map_paraboloids.glsl"

#include "blocker_search.glsl"
#include "light_filter.glsl"
#include "pixel.glsl"

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  vec2 noise = kernel_noise(noise_position());
  float z_blocker = mean_blocker_distance(light, receiver, noise, view_light.depth_range.x);
  return visible_share(light, receiver, z_blocker, z_blocker < receiver.p_light.z, noise);
}

void main() {
  Receiver receiver;
  out_visibility = face_pixel() && fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

// SPDX-License-Identifier: Apache-2.0
// Percentage-closer soft shadows (Fernando 2005) over cascades: penumbrae have the sun's size in the world, so they are
// as wide in every map.
#include "cascades.glsl"

#include "blocker_search.glsl"
#include "light_filter.glsl"

float visibility_of(Receiver receiver) {
  AreaLight light = kernel_light();
  vec2 noise = kernel_noise(noise_position());
  float z_blocker = mean_blocker_distance(light, receiver, noise, view_light.depth_range.x);
  return visible_share(light, receiver, z_blocker, z_blocker < receiver.p_light.z, noise);
}

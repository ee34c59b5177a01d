// SPDX-License-Identifier: Apache-2.0
// The width of the penumbra at the pixel in the middle of each texel (Sterna 2018, 2.2).
#include "blocker_search.glsl"
#include "light_kernel.glsl"
#include "mask_value.glsl"
#include "pixel.glsl"
#include "search_bound.glsl"

vec2 mask_of(Receiver receiver, vec2 noise) {
  AreaLight light = widened(kernel_light(), search_scale);
  float z_blocker = mean_blocker_distance(light, receiver, noise, nearest_blocker_bound(light, receiver));
  if (z_blocker >= receiver.p_light.z) return default_value();
  return vec2(penumbra_of(view_light, receiver.p_light.z, z_blocker), 1.0);
}

void main() {
  ivec2 px = pixel_of_texel(ivec2(gl_FragCoord.xy));
  Receiver receiver;
  bool has_receiver = fetch_receiver_at(px, receiver);
  vec2 noise = kernel_noise(noise_position_at(vec2(px) + 0.5));
  out_mask = stored(has_receiver ? mask_of(receiver, noise) : default_value());
}

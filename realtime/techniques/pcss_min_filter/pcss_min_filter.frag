// SPDX-License-Identifier: Apache-2.0
// The filter of pcss for a blocker distance that was prepared in the map (Sterna 2018, 2.3).
#include "blocker_truth.glsl"
#include "light_filter.glsl"
#include "light_kernel.glsl"
#include "pixel.glsl"

float visibility_of(Receiver receiver) {
  vec2 uv = texel_position(view_light, receiver.lateral) / view_light.depth_range.w;
  bool has_blocker = !is_behind(view_light, receiver);
  float z_blocker = min(texture(blocker, uv).r, receiver.p_light.z);
#ifdef BLOCKER_FROM_TRUTH
  z_blocker = true_blocker_distance(view_light, receiver);
#endif
  return visible_share(kernel_light(), receiver, z_blocker, has_blocker, kernel_noise(noise_position()));
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

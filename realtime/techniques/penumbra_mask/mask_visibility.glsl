// SPDX-License-Identifier: Apache-2.0
// The filter of pcss as wide as the mask says.
#include "light_filter.glsl"
#include "light_kernel.glsl"
#include "mask_value.glsl"
#include "pixel.glsl"

/// Of the receiver seen at `frag_coord` (GL's rows).
float masked_visibility(Receiver receiver, vec2 frag_coord, vec2 noise) {
  vec2 read = texture(mask, texel_of_pixel(frag_coord) * mask_size.zw).rg;
  bool has_blocker = read.g > 0.0 && !is_behind(view_light, receiver);
  float z_receiver = receiver.p_light.z;
  float z_blocker = has_blocker ? blocker_distance_of(view_light, z_receiver, read.r / read.g) : z_receiver;
  return visible_share(kernel_light(), receiver, z_blocker, has_blocker, noise);
}

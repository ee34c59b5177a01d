// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering where the mask is on, one comparison elsewhere (Evans, Agenjo and Blat 2014).
#include "dilated_mask.glsl"
#include "masked_filter.glsl"

bool is_near_edge(Receiver receiver) {
  return highest_around(mask, textureQueryLevels(mask) - 1, texel_position(view_light, receiver.lateral)) > 0.0;
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return masked_lit(shadow_map, view_light, receiver, is_near_edge(receiver) ? filter_width_texels : 0.0);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

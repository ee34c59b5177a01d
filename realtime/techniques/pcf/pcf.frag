// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering with one box for all receivers.
#include "box_pcf.glsl"
#include "pixel.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return box_lit(shadow_map, view_light, receiver, filter_width_texels);
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering, and what the picture itself shows between the receiver and the light: the darker counts, as
// in engines that fill contacts in so.
#include "box_pcf.glsl"
#include "pixel.glsl"
#include "screen_trace.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return min(box_lit(shadow_map, view_light, receiver, filter_width_texels), screen_visibility());
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

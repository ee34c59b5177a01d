// SPDX-License-Identifier: Apache-2.0
// Hard shadows from two paraboloids: one comparison a pixel, whichever half it falls into.
#include "map_paraboloids.glsl"
#include "pixel.glsl"

float hard_visibility(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  vec2 lateral_met;
  float z_met;
  return find_blocker_at(shadow_map, view_light, receiver, receiver.lateral, lateral_met, z_met) ? 0.0 : 1.0;
}

void main() {
  Receiver receiver;
  out_visibility = face_pixel() && fetch_receiver(receiver) ? hard_visibility(receiver) : 1.0;
}

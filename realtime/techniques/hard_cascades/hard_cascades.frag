// SPDX-License-Identifier: Apache-2.0
// Hard shadows from cascades: one comparison a pixel, two where one map fades into the next.
#include "cascades.glsl"

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  vec2 lateral_met;
  float z_met;
  return find_blocker_at(shadow_map, view_light, receiver, receiver.lateral, lateral_met, z_met) ? 0.0 : 1.0;
}

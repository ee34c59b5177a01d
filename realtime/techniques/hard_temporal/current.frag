// SPDX-License-Identifier: Apache-2.0
// This frame's comparison with its own map.
#include "pixel.glsl"
#include "shadow_map.glsl"

void main() {
  Receiver receiver;
  out_current = fetch_receiver(receiver) ? hard_visibility(shadow_map, view_light, receiver) : 1.0;
}

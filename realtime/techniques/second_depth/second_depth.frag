// SPDX-License-Identifier: Apache-2.0
// One comparison a pixel with the second surface.
#include "pixel.glsl"
#include "shadow_map.glsl"

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? hard_visibility(shadow_map, view_light, receiver) : 1.0;
}

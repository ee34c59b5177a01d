// SPDX-License-Identifier: Apache-2.0
// Hard shadow map (Williams 1978): lit unless the map holds something nearer to the light.
#include "pixel.glsl"
#include "shadow_map.glsl"

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? hard_visibility(shadow_map, view_light, receiver) : 1.0;
}

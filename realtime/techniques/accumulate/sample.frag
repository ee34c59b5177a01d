// SPDX-License-Identifier: Apache-2.0
// One light sample's share of the mean: a hard shadow map from that point of the light.
#include "pixel.glsl"
#include "shadow_map.glsl"

void main() {
  Receiver receiver;
  float seen = fetch_receiver(receiver) ? hard_visibility(shadow_map, view_light, receiver) : 1.0;
  out_visibility = seen / float(i_count);
}

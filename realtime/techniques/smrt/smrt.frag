// SPDX-License-Identifier: Apache-2.0
// Shadow-map ray tracing over a single map.
#define LAMP_RAYS
#include "map_rays.glsl"

float stored_depth(ivec2 texel) { return texelFetch(shadow_map, texel, 0).r; }

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? share_of_rays(receiver) : 1.0;
}

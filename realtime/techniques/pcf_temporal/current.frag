// SPDX-License-Identifier: Apache-2.0
// This frame's share of a disk of depth comparisons: the taps after those of the frame before.
#include "pixel.glsl"
#include "r2_sequence.glsl"
#include "shadow_map.glsl"

float disk_mean(Receiver receiver) {
  vec2 center = texel_position(view_light, receiver.lateral);
  vec2 offset = r2_offset(noise_position());
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    vec2 tap = concentric_disk(r2_point(history.frame.x * TAPS + i, offset));
    lit += lit_at(shadow_map, view_light, receiver, center + radius_texels * tap, BILINEAR != 0);
  }
  return lit / float(TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  return is_known(view_light, receiver, known) ? known : disk_mean(receiver);
}

void main() {
  Receiver receiver;
  out_current = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over two paraboloids: taps on a disk around the receiver's direction, in whichever half they fall.
#include "map_paraboloids.glsl"
#include "pixel.glsl"

float disk_mean(Receiver receiver, float rotation_rad) {
  float radius = radius_texels * texel_lateral(view_light);
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    vec2 lateral = receiver.lateral + radius * vogel_disk(i, TAPS, rotation_rad);
    vec2 lateral_met;
    float z_met;
    if (!find_blocker_at(shadow_map, view_light, receiver, lateral, lateral_met, z_met)) lit += 1.0;
  }
  return lit / float(TAPS);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  return disk_mean(receiver, NOISE != 0 ? kTwoPi * interleaved_gradient_noise(noise_position()) : 0.0);
}

void main() {
  Receiver receiver;
  out_visibility = face_pixel() && fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}

// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over a cube of maps: taps on a disk around the receiver's direction, each a comparison of
// the hardware's, blended over four texels that may lie on two faces.
#include "map_cube.glsl"

#include "blended_tap.glsl"
#include "pixel.glsl"

float lit_at_tap(Receiver receiver, vec2 lateral) {
  vec3 offset_world = direction_at(view_light, lateral) * blended_tap_distance(view_light, receiver, lateral);
  float depth_reversed = depth_of_distance(view_light, face_distance(offset_world));
  return texture(shadow_map, vec4(offset_world, depth_reversed));
}

float disk_mean(Receiver receiver, float rotation_rad) {
  float radius = radius_texels * texel_lateral(view_light);
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    lit += lit_at_tap(receiver, receiver.lateral + radius * vogel_disk(i, TAPS, rotation_rad));
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

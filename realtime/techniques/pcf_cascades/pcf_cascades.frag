// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over cascades: taps on a disk of one radius in the world, each a comparison of the
// hardware's, blended over four texels.
#include "cascades.glsl"

#include "blended_tap.glsl"

float lit_at_tap(Receiver receiver, vec2 lateral) {
  vec2 uv = texel_position(view_light, lateral) / view_light.depth_range.w;
  float depth_reversed = depth_of_distance(view_light, blended_tap_distance(view_light, receiver, lateral));
  return texture(shadow_map, vec4(uv, float(map_layer), depth_reversed));
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  float rotation_rad = NOISE != 0 ? kTwoPi * interleaved_gradient_noise(noise_position()) : 0.0;
  float radius = max(radius_world, radius_texels * texel_lateral(view_light));
  float lit = 0.0;
  for (int i = 0; i < TAPS; ++i) {
    lit += lit_at_tap(receiver, receiver.lateral + radius * vogel_disk(i, TAPS, rotation_rad));
  }
  return lit / float(TAPS);
}

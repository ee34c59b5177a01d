// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over cascades: taps on a disk of one radius in the world, each a comparison of the
// hardware's, blended over four texels. For techniques with the parameters of cascade_disk.toml. What includes this says
// where the maps lie: blended_comparison().
#include "cascades.glsl"

#include "blended_tap.glsl"

/// The comparisons of the four texels of the chosen cascade's map around `p_texels`, blended. Outside the map all is lit.
float blended_comparison(vec2 p_texels, float depth_reversed);

float lit_at_tap(Receiver receiver, vec2 lateral) {
  float depth_reversed = depth_of_distance(view_light, blended_tap_distance(view_light, receiver, lateral));
  return blended_comparison(texel_position(view_light, lateral), depth_reversed);
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
